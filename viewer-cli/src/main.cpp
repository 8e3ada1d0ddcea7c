#include <rastertrace/trace/write_trace.h>
#include <rastertrace/trace/scene_file.h>
#include <cstdio>
using namespace rastertrace;
int main(int, char** v) {
  try {
    auto s = read_source(v[1]);
    if (!s) { puts(to_text(s.problem()).c_str()); return 2; }
    auto scene = read_scene(s.value());
    if (!scene) { puts(to_text(scene.problem()).c_str()); return 2; }
    DescriptorOutput o(1, "stdout");
    write_trace(scene.value(), {}, o);
  } catch (const Problem& p) { puts(to_text(p).c_str()); return 3; }
}
