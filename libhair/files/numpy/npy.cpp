#include <libhair/files/numpy/npy.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <glm/gtc/packing.hpp>

#include <libhair/files/byte_reader.h>
#include <libhair/files/text_reader.h>

namespace hair {

namespace {

constexpr std::string_view kMagic("\x93NUMPY", 6);

// The value of a key in Python's notation, from behind the colon to the end of the header.
std::string_view valueOf(std::string_view header, std::string_view key, const ByteReader& in) {
  std::size_t at = header.find(text("'", key, "'"));
  in.expect(at != std::string_view::npos, "the header says nothing of ", key);
  at = header.find(':', at);
  in.expect(at != std::string_view::npos, "the header says nothing of ", key);
  std::string_view value = header.substr(at + 1);
  value.remove_prefix(std::min(value.find_first_not_of(' '), value.size()));
  return value;
}

std::vector<std::size_t> shapeOf(std::string_view tuple, const ByteReader& in) {
  in.expect(tuple.starts_with('(') && tuple.find(')') != std::string_view::npos,
            "the header's shape is no tuple");
  tuple = tuple.substr(1, tuple.find(')') - 1);
  std::vector<std::size_t> shape;
  std::size_t all = 1;
  while (!tuple.empty()) {
    const std::size_t comma = std::min(tuple.find(','), tuple.size());
    std::string_view word = tuple.substr(0, comma);
    tuple.remove_prefix(std::min(comma + 1, tuple.size()));
    word.remove_prefix(std::min(word.find_first_not_of(' '), word.size()));
    while (word.ends_with(' ') || word.ends_with('L')) word.remove_suffix(1);
    if (word.empty()) continue;
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    in.expect(error == std::errc() && end == word.data() + word.size(), "the header's shape has '",
              TextReader::shown(word), "'");
    in.expect(number == 0 || all <= std::numeric_limits<std::size_t>::max() / 16 / number,
              "the header's shape is beyond all files");
    if (number > 0) all *= number;
    in.expect(shape.size() < 32, "the header's shape has more than 32 numbers");
    shape.push_back(number);
  }
  return shape;
}

template <class T>
T readAt(const NpyArray& array, std::size_t place) {
  std::array<char, sizeof(T)> bytes;
  std::memcpy(bytes.data(), array.data.data() + place * sizeof(T), sizeof(T));
  if (array.bigEndian) std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<T>(bytes);
}

// Where item i is stored.
std::size_t placeOf(const NpyArray& array, std::size_t i) {
  if (!array.columnsFirst) return i;
  std::size_t place = 0, stride = array.size();
  for (std::size_t d = array.shape.size(); d-- > 0;) {
    stride /= array.shape[d];
    place += i % array.shape[d] * stride;
    i /= array.shape[d];
  }
  return place;
}

}  // namespace

std::size_t NpyArray::size() const {
  std::size_t all = 1;
  for (const std::size_t n : shape) all *= n;
  return all;
}

double NpyArray::item(std::size_t i) const {
  const std::size_t place = placeOf(*this, i);
  if (kind == 'f') {
    if (itemBytes == 2)
      return static_cast<double>(glm::unpackHalf1x16(readAt<std::uint16_t>(*this, place)));
    if (itemBytes == 4) return static_cast<double>(readAt<float>(*this, place));
    return readAt<double>(*this, place);
  }
  const bool sign = kind == 'i';
  switch (itemBytes) {
    case 1:
      return sign ? static_cast<double>(readAt<std::int8_t>(*this, place))
                  : static_cast<double>(readAt<std::uint8_t>(*this, place));
    case 2:
      return sign ? static_cast<double>(readAt<std::int16_t>(*this, place))
                  : static_cast<double>(readAt<std::uint16_t>(*this, place));
    case 4:
      return sign ? static_cast<double>(readAt<std::int32_t>(*this, place))
                  : static_cast<double>(readAt<std::uint32_t>(*this, place));
    default:
      return sign ? static_cast<double>(readAt<std::int64_t>(*this, place))
                  : static_cast<double>(readAt<std::uint64_t>(*this, place));
  }
}

std::vector<float> NpyArray::floats() const {
  std::vector<float> values(size());
  if (kind == 'f' && itemBytes == 4 && !bigEndian && !columnsFirst) {
    if (!values.empty()) std::memcpy(values.data(), data.data(), values.size() * sizeof(float));
    return values;
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double value = item(i);
    require(!(std::abs(value) > std::numeric_limits<float>::max()) || std::isinf(value), name,
            ": item ", i, " is ", value, ", beyond all floats");
    values[i] = static_cast<float>(value);
  }
  return values;
}

NpyArray parseNpy(std::string_view bytes, std::string_view name) {
  ByteReader in(bytes, name);
  in.expect(bytes.starts_with(kMagic), "'\\x93NUMPY' expected: this is no .npy file");
  in.expect(bytes.size() > 12, "the file ends within its header (truncated)");
  in.seek(kMagic.size(), "version");
  const auto version = in.read<std::uint8_t>("version");
  in.read<std::uint8_t>("version");
  in.expect(version >= 1 && version <= 3, "version ", int{version}, " of .npy; 1 to 3 are read");
  const std::size_t length = version == 1 ? std::size_t{in.read<std::uint16_t>("header")}
                                          : std::size_t{in.read<std::uint32_t>("header")};
  in.expectLeft(length, 1, "header");
  const std::string_view header = bytes.substr(in.offset(), length);

  NpyArray array;
  array.name = name;
  std::string_view descr = valueOf(header, "descr", in);
  in.expect(descr.size() > 4 && (descr[0] == '\'' || descr[0] == '"'),
            "an array of structures; save its points as an array of numbers");
  descr = descr.substr(1, std::min(descr.find(descr[0], 1), descr.size()) - 1);
  in.expect(descr.find('O') == std::string_view::npos,
            "an array of objects (pickled, of unequal lengths perhaps); save points "
            "[n, 3] and the counts of strands");
  in.expect(descr.size() >= 3 && std::string_view("<>|=").find(descr[0]) != std::string_view::npos,
            "the type '", TextReader::shown(descr), "' is none of NumPy's");
  array.bigEndian = descr[0] == '>';
  array.kind = descr[1];
  const std::string_view digits = descr.substr(2);
  const bool known = array.kind == 'f'   ? digits == "2" || digits == "4" || digits == "8"
                     : array.kind == 'b' ? digits == "1"
                     : array.kind == 'i' || array.kind == 'u'
                         ? digits == "1" || digits == "2" || digits == "4" || digits == "8"
                         : false;
  in.expect(known, "the type '", TextReader::shown(descr),
            "' is not read; save whole numbers, or floats of 2, 4 or 8 bytes");
  array.itemBytes = static_cast<std::size_t>(digits[0] - '0');
  array.columnsFirst = valueOf(header, "fortran_order", in).starts_with("True");
  array.shape = shapeOf(valueOf(header, "shape", in), in);
  const std::size_t begin = in.offset() + length;
  in.expect(array.size() <= (bytes.size() - begin) / array.itemBytes, array.size(), " items of ",
            array.itemBytes, " bytes are announced but ", bytes.size() - begin,
            " bytes are left (truncated, or a bad shape)");
  array.data = bytes.substr(begin, array.size() * array.itemBytes);
  return array;
}

}  // namespace hair
