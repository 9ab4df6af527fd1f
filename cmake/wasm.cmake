# cmake --toolchain cmake/wasm.cmake ...: for WebAssembly with WASI, by clang and its libc++; programs run in node.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_C_COMPILER clang-19)
set(CMAKE_CXX_COMPILER clang++-19)
set(CMAKE_C_COMPILER_TARGET wasm32-wasi)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
set(CMAKE_CXX_FLAGS_INIT -stdlib=libc++)
# the stack below the data: a program that needs more than there is stops instead of writing over them
set(CMAKE_EXE_LINKER_FLAGS_INIT -Wl,--stack-first)
set(CMAKE_CROSSCOMPILING_EMULATOR node --no-warnings ${CMAKE_CURRENT_LIST_DIR}/wasi.mjs)
