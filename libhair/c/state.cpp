#include <algorithm>
#include <istream>
#include <ostream>
#include <streambuf>

#include <libhair/c/boundary.h>
#include <libhair/c/instance.h>

using namespace hair::c;
using hair::require;

namespace {

// Reads from the caller's bytes.
struct Reading : std::streambuf {
  Reading(const void* bytes, std::size_t size) {
    char* begin = const_cast<char*>(static_cast<const char*>(bytes));
    setg(begin, begin, begin + size);
  }
};

// Writes to the caller's buffer: counts all bytes, stores those that fit.
class Writing : public std::streambuf {
 public:
  Writing(void* bytes, std::size_t room) : bytes_(static_cast<char*>(bytes)), room_(room) {}
  std::size_t size() const { return size_; }

 protected:
  std::streamsize xsputn(const char* from, std::streamsize count) override {
    const auto n = static_cast<std::size_t>(count);
    if (size_ + n <= room_) std::copy_n(from, n, bytes_ + size_);
    size_ += n;
    return count;
  }
  int_type overflow(int_type c) override {
    const char byte = traits_type::to_char_type(c);
    xsputn(&byte, 1);
    return traits_type::not_eof(c);
  }

 private:
  char* bytes_;
  std::size_t room_, size_ = 0;
};

std::size_t save(const hair::Simulation& simulation, void* bytes, std::size_t room) {
  Writing writing(bytes, room);
  std::ostream out(&writing);
  simulation.save(out);
  return writing.size();
}

}  // namespace

hair_status hair_read(const hair_instance* hair, hair_view* view) {
  return guarded([&] {
    const hair::Hair& h = given(hair, "hair_instance").simulation.hair();
    given(view, "hair_view");
    hair_view v{};
    v.light_count = static_cast<uint32_t>(h.maps.size());
    v.strand_count = static_cast<uint32_t>(h.groom->strandCount());
    v.point_count = static_cast<uint32_t>(h.wisps.points.size());
    v.points = &h.wisps.points.data()->x;
    const hair::StrandView strands = h.strands();
    v.first = strands.first.data();
    for (std::size_t s = 0; s < strands.strandCount(); ++s)
      v.drawn_count += strands.first[s + 1] > strands.first[s];
    v.wider = h.wisps.drawn.wider;
    v.transmittance = h.transmittance.empty() ? nullptr : h.transmittance.data();
    v.colours = h.colours.empty() ? nullptr : reinterpret_cast<const uint8_t*>(h.colours.data());
    v.radiance = h.radiance.empty() ? nullptr : &h.radiance.data()->x;
    v.time = h.time;
    hand(v, view, view->size, "hair_view");
  });
}

hair_status hair_state_hash(const hair_instance* hair, uint64_t* hash) {
  return guarded([&] {
    given(hash, "hash");
    *hash = given(hair, "hair_instance").simulation.stateHash();
  });
}

hair_status hair_save(const hair_instance* hair, void* bytes, size_t capacity, size_t* size) {
  return guarded([&] {
    given(hair, "hair_instance");
    given(size, "size");
    const std::size_t needed = save(hair->simulation, nullptr, 0);
    require(!bytes || capacity >= needed, "hair_save: ", needed, " bytes, but room for ", capacity);
    if (bytes) save(hair->simulation, bytes, capacity);
    *size = needed;
  });
}

hair_status hair_restore(hair_instance* hair, const void* bytes, size_t size) {
  return computed([&] {
    given(hair, "hair_instance");
    require(bytes || size == 0, "hair_restore: bytes is null");
    Reading reading(bytes, size);
    std::istream in(&reading);
    hair->simulation.restore(in);
  });
}
