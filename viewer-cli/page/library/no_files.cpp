// SPDX-License-Identifier: MIT
// A page has no files: whatever is looked for is not there. A scene that names an OBJ file is told so, like any
// other whose file is missing. (Emscripten's own stand-ins say that every file is there.)

#include <cerrno>

extern "C" {

long __syscall_open(long, long, ...) {
    return -ENOENT;
}
long __syscall_stat64(long, long) {
    return -ENOENT;
}
long __syscall_lstat64(long, long) {
    return -ENOENT;
}
long __syscall_fstat64(long, long) {
    return -ENOENT;
}
long __syscall_fstatat64(long, long, long, long) {
    return -ENOENT;
}
long __syscall_readlink(long, long, long) {
    return -ENOENT;
}
long __syscall_getcwd(long, long) {
    return -ENOENT;
}
}
