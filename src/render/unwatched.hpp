#pragma once

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define FRESNEL_WATCHED
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) && !defined(FRESNEL_WATCHED)
#define FRESNEL_WATCHED
#endif
#ifdef FRESNEL_WATCHED
#include <sanitizer/lsan_interface.h>
#endif

namespace fresnel::render {

/// While one lives, what this thread allocates is no leak: Mesa's drivers keep some memory until the process ends, under
/// no name that a suppression could hold, since they are unloaded by then.
struct unwatched {
#ifdef FRESNEL_WATCHED
    unwatched() { __lsan_disable(); }
    ~unwatched() { __lsan_enable(); }
#else
    unwatched() = default;
    ~unwatched() {} // not trivial, so that it is never an unused variable
#endif
    unwatched(const unwatched&) = delete;
    unwatched& operator=(const unwatched&) = delete;
};

} // namespace fresnel::render
