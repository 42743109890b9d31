#pragma once

#include <mutex>

#if defined(__GNUC__) && !defined(__clang__)
// With sanitizers g++ 12 sees vectors without a value in OpenMesh's headers; there are none.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>

namespace hair {

using OpenPolyMesh = OpenMesh::PolyMesh_ArrayKernelT<>;

// OpenMesh reports complex edges on its error stream; here the caller gets them as values.
// The stream is one for the whole program, so one thread silences it at a time.
class SilentOpenMesh {
 public:
  SilentOpenMesh() : lock_(mutex()), was_(omerr().is_enabled()) { omerr().disable(); }
  ~SilentOpenMesh() {
    if (was_) omerr().enable();
  }
  SilentOpenMesh(const SilentOpenMesh&) = delete;
  SilentOpenMesh& operator=(const SilentOpenMesh&) = delete;

 private:
  static std::mutex& mutex() {
    static std::mutex m;
    return m;
  }
  std::lock_guard<std::mutex> lock_;
  bool was_;
};

}  // namespace hair
