// Saved states. What has the wrong check sum goes no farther, so each is tried with the right one
// too.
#include <sstream>
#include <string>

#include <libhair/core/error.h>
#include <libhair/simulation/frame.h>

#include "promise.h"
#include "small_hair.h"
#include "targets.h"

namespace hair {

namespace {

bool restores(const std::string& bytes, SmallHair& small) {
  const std::string before = small.state();
  std::istringstream in(bytes);
  try {
    restoreState(in, small.hair);
    return true;
  } catch (const Error& e) {
    promise(std::string_view(e.what()).starts_with("saved state: "), "an error names the state");
    promise(small.state() == before, "hair that is not restored is as it was");
    return false;
  }
}

}  // namespace

bool fuzzState(std::string_view bytes) {
  static const std::string good = [] {
    SmallHair small;
    for (int f = 0; f < 2; ++f) small.step();
    return small.state();
  }();
  static SmallHair small;
  bool read = false;
  for (const std::string& state : {std::string(bytes), withCheckSum(std::string(bytes))}) {
    promise(restores(good, small), "a good state is restored, whatever was before it");
    if (!restores(state, small)) continue;
    read = true;
    // That only what is sound is restored makes it the judge of what the next frame leaves.
    promise(restores(small.state(), small), "what was restored can be saved");
    try {
      small.step();
    } catch (const Error& e) {
      promise(false, e.what());
    }
    promise(restores(small.state(), small), "the next frame leaves sound hair");
  }
  return read;
}

}  // namespace hair
