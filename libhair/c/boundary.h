#pragma once

#include <cstring>
#include <exception>
#include <new>
#include <optional>
#include <string_view>

#include <libhair/c/hair.h>
#include <libhair/core/error.h>
#include <libhair/core/parallel.h>

namespace hair::c {

/// Wrappers of all functions of the C interface: they convert exceptions to status codes.

hair_status failed(hair_status status, const char* why) noexcept;

template <class Work>
hair_status guarded(Work&& work) noexcept {
  try {
    work();
    return HAIR_OK;
  } catch (const Error& error) {
    return failed(HAIR_BAD_ARGUMENT, error.what());
  } catch (const std::bad_alloc&) {
    return failed(HAIR_OUT_OF_MEMORY, "out of memory");
  } catch (const std::exception& error) {
    return failed(HAIR_INTERNAL_ERROR, error.what());
  } catch (...) {
    return failed(HAIR_INTERNAL_ERROR, "an exception of an unknown kind");
  }
}

/// Applies the thread settings (hair_use_threads, hair_use_pool) to loops during one call; the
/// host's own work between calls is unaffected.
class ThreadsInUse {
 public:
  ThreadsInUse();

 private:
  // A copy: a host's run() may do other work meanwhile and switch to another pool.
  struct CallersPool final : ThreadPool {
    explicit CallersPool(const hair_pool& pool) : own(pool) {}
    int threadCount() const override { return static_cast<int>(own.thread_count); }
    void run(std::size_t taskCount, const Tasks& tasks) override {
      own.run(own.user, taskCount, reinterpret_cast<const hair_tasks*>(&tasks));
    }
    hair_pool own;
  };
  std::optional<ThreadLimit> limit_;
  std::optional<CallersPool> callers_;
  std::optional<ThreadPoolScope> pool_;
};

/// The same, for calls with parallel loops.
template <class Work>
hair_status computed(Work&& work) noexcept {
  return guarded([&] {
    const ThreadsInUse threads;
    work();
  });
}

template <class T>
T& given(T* pointer, std::string_view name) {
  require(pointer != nullptr, name, ": is null");
  return *pointer;
}

/// Smallest accepted size of each growing struct: that of version 1.0. Never changes, because old
/// programs keep passing it.
template <class T>
inline constexpr std::size_t kFirstSize = 0;
template <>
inline constexpr std::size_t kFirstSize<hair_settings> = 228;
template <>
inline constexpr std::size_t kFirstSize<hair_style> = 32;
template <>
inline constexpr std::size_t kFirstSize<hair_binding> = 16;
template <>
inline constexpr std::size_t kFirstSize<hair_body> = 40 + 2 * sizeof(void*);
template <>
inline constexpr std::size_t kFirstSize<hair_view> = 32 + 4 * sizeof(void*);
template <>
inline constexpr std::size_t kFirstSize<hair_map> = 36;
template <>
inline constexpr std::size_t kFirstSize<hair_pool> = 8 + 2 * sizeof(void*);

/// Larger sizes are rejected as uninitialised.
inline constexpr std::size_t kLargestSize = 4096;

template <class T>
void requireSize(std::size_t size, std::string_view name) {
  static_assert(kFirstSize<T> > 0 && kFirstSize<T> <= sizeof(T));
  require(size >= kFirstSize<T> && size <= kLargestSize, name, ": size ", size, " is not in ",
          kFirstSize<T>, " to ", kLargestSize, "; set it to sizeof(", name, ")");
}

/// Reads a growing struct of any version: fields missing in an older one come from `defaults`;
/// bytes beyond this version must be zero.
template <class T>
T taken(const T* from, T defaults, std::string_view name) {
  given(from, name);
  std::uint32_t size;
  std::memcpy(&size, from, sizeof size);
  requireSize<T>(size, name);
  const auto* bytes = reinterpret_cast<const unsigned char*>(from);
  for (std::size_t b = sizeof(T); b < size; ++b)
    require(bytes[b] == 0, name, ": byte ", b,
            " says what only a later version of the library can");
  std::memcpy(static_cast<void*>(&defaults), bytes, size < sizeof(T) ? size : sizeof(T));
  return defaults;
}

/// Writes a growing struct: as much of `value` as `size` bytes hold, then zeros.
template <class T>
void hand(T value, T* to, std::size_t size, std::string_view name) {
  given(to, name);
  requireSize<T>(size, name);
  value.size = static_cast<std::uint32_t>(size);
  auto* bytes = reinterpret_cast<unsigned char*>(to);
  std::memcpy(bytes, &value, size < sizeof(T) ? size : sizeof(T));
  if (size > sizeof(T)) std::memset(bytes + sizeof(T), 0, size - sizeof(T));
}

}  // namespace hair::c
