// Strands in arrays of NumPy. Files are written here by a plain writer; streams of deflate are
// those of Python's zlib, as bytes.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include <gtest/gtest.h>

#include <libhair/files/numpy/inflate.h>
#include <libhair/files/numpy/npz_strands.h>

#include "grooms.h"
#include "samples.h"

namespace hair {
namespace {

template <class T>
void append(std::string& bytes, T value, bool big = false) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), &value, sizeof(T));
  if (big) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

// An array of type T; `order` names it in NumPy's words.
template <class T>
std::string npy(const std::string& descr, const std::vector<std::size_t>& shape,
                const std::vector<T>& values, int version = 1, bool columnsFirst = false) {
  std::string tuple;
  for (const std::size_t n : shape) tuple += text(n, ", ");
  if (shape.size() > 1) tuple.resize(tuple.size() - 2);
  std::string header =
      text("{'descr': '", descr, "', 'fortran_order': ", columnsFirst ? "True" : "False",
           ", 'shape': (", tuple, "), }");
  while ((10 + header.size() + 1) % 64 != 0) header += ' ';
  header += '\n';
  std::string bytes("\x93NUMPY", 6);
  bytes += static_cast<char>(version);
  bytes += '\0';
  if (version == 1)
    append(bytes, static_cast<std::uint16_t>(header.size()));
  else
    append(bytes, static_cast<std::uint32_t>(header.size()));
  bytes += header;
  for (const T value : values) append(bytes, value, descr[0] == '>');
  return bytes;
}

template <class T>
std::vector<T> numbersOf(const StrandSet& strands) {
  std::vector<T> numbers;
  for (const glm::vec3 p : strands.points)
    for (int c = 0; c < 3; ++c) numbers.push_back(static_cast<T>(p[c]));
  return numbers;
}

std::uint32_t crcOf(const std::string& bytes) {
  std::uint32_t sum = ~0u;
  for (const char c : bytes) {
    sum ^= static_cast<unsigned char>(c);
    for (int k = 0; k < 8; ++k) sum = (sum >> 1) ^ (0xedb88320u & (0u - (sum & 1u)));
  }
  return ~sum;
}

struct Packed {
  std::string name, plain, packed;
  std::uint16_t method = 0;
};

// As Python's zipfile lays it out.
std::string zipOf(const std::vector<Packed>& files) {
  std::string bytes, directory;
  for (const Packed& file : files) {
    const auto place = static_cast<std::uint32_t>(bytes.size());
    const std::string& content = file.method == 0 ? file.plain : file.packed;
    const auto fields = [&](std::string& out) {
      append(out, std::uint16_t{20});
      append(out, std::uint16_t{0});
      append(out, file.method);
      append(out, std::uint32_t{0});
      append(out, crcOf(file.plain));
      append(out, static_cast<std::uint32_t>(content.size()));
      append(out, static_cast<std::uint32_t>(file.plain.size()));
      append(out, static_cast<std::uint16_t>(file.name.size()));
    };
    bytes += "PK\x03\x04";
    fields(bytes);
    append(bytes, std::uint16_t{20});  // an extra field, as NumPy has
    bytes += file.name + std::string(20, '\0') + content;
    directory += "PK\x01\x02";
    append(directory, std::uint16_t{20});
    fields(directory);
    directory += std::string(12, '\0');  // extra field, comment, disk, attributes
    append(directory, place);
    directory += file.name;
  }
  const auto place = static_cast<std::uint32_t>(bytes.size());
  bytes += directory + "PK\x05\x06" + std::string(4, '\0');
  append(bytes, static_cast<std::uint16_t>(files.size()));
  append(bytes, static_cast<std::uint16_t>(files.size()));
  append(bytes, static_cast<std::uint32_t>(directory.size()));
  append(bytes, place);
  return bytes + std::string(2, '\0');
}

std::string npz(const std::vector<std::pair<std::string, std::string>>& arrays) {
  std::vector<Packed> files;
  for (const auto& [name, bytes] : arrays) files.push_back({name + ".npy", bytes, {}, 0});
  return zipOf(files);
}

void expectNear(const StrandFile& file, const StrandSet& strands, float within,
                const std::string& of) {
  SCOPED_TRACE(of);
  ASSERT_EQ(file.strands.first, strands.first);
  for (std::size_t i = 0; i < strands.pointCount(); ++i)
    ASSERT_LE(glm::distance(file.strands.points[i], strands.points[i]), within) << i;
}

TEST(Numpy, ArraysOfEveryTypeAndOrder) {
  const StrandSet strands = sampleGroom();
  const std::vector<std::size_t> shape = {60, 12, 3};
  const auto floats = numbersOf<float>(strands);
  const auto doubles = numbersOf<double>(strands);
  for (const int version : {1, 2, 3})
    expectNear(parseNumpy(npy("<f4", shape, floats, version), "a.npy"), strands, 0, "<f4");
  expectNear(parseNumpy(npy(">f4", shape, floats), "a.npy"), strands, 0, ">f4");
  expectNear(parseNumpy(npy("<f8", shape, doubles), "a.npy"), strands, 0, "<f8");
  expectNear(parseNumpy(npy(">f8", shape, doubles), "a.npy"), strands, 0, ">f8");
  // Halves: 1.6 m to half a millimetre. Their bits are cut out of the floats'.
  std::vector<std::uint16_t> halves;
  for (const float f : floats) {
    const auto bits = std::bit_cast<std::uint32_t>(f);
    const int exponent = static_cast<int>((bits >> 23) & 255) - 112;
    halves.push_back(static_cast<std::uint16_t>(
        exponent <= 0 ? 0
                      : (bits >> 31 << 15) | static_cast<std::uint32_t>(exponent) << 10 |
                            ((bits >> 13) & 1023)));
  }
  expectNear(parseNumpy(npy("<f2", shape, halves), "a.npy"), strands, 2.5e-3f, "<f2");
  std::vector<float> columns(floats.size());
  for (std::size_t s = 0; s < 60; ++s)
    for (std::size_t i = 0; i < 12; ++i)
      for (std::size_t c = 0; c < 3; ++c)
        columns[s + 60 * (i + 12 * c)] = floats[3 * (12 * s + i) + c];
  expectNear(parseNumpy(npy("<f4", shape, columns, 1, true), "a.npy"), strands, 0, "columns first");
}

TEST(Numpy, PaddingIsNoPoints) {
  StrandSet strands = sampleGroom({.strands = 20, .points = 8, .uneven = true});
  std::vector<float> padded;
  for (std::size_t s = 0; s < strands.strandCount(); ++s)
    for (std::size_t i = 0; i < 8; ++i)
      for (int c = 0; c < 3; ++c)
        padded.push_back(i < strands.strand(s).size() ? strands.strand(s)[i][c] : NAN);
  expectNear(parseNumpy(npy("<f4", {20, 8, 3}, padded), "a.npy"), strands, 0, "NaN");
  padded[0] = NAN;  // within a strand it is damage
  EXPECT_NE(errorOf([&] {
              parseNumpy(npy("<f4", {20, 8, 3}, padded), "a.npy");
            }).find("point 0 is not finite"),
            std::string::npos);
}

TEST(Numpy, FlatPointsWithWhatSaysTheirStrands) {
  const StrandSet strands = sampleGroom({.strands = 40, .points = 9, .uneven = true});
  const std::size_t n = strands.pointCount();
  const std::string points = npy("<f4", {n, 3}, numbersOf<float>(strands));
  std::vector<std::int64_t> counts, offsets, starts, ends, ids;
  for (std::size_t s = 0; s < 40; ++s) {
    counts.push_back(static_cast<std::int64_t>(strands.strand(s).size()));
    starts.push_back(strands.first[s]);
    ends.push_back(strands.first[s + 1]);
    for (std::size_t i = 0; i < strands.strand(s).size(); ++i)
      ids.push_back(static_cast<std::int64_t>(s));
  }
  offsets = starts;
  offsets.push_back(static_cast<std::int64_t>(n));
  const auto with = [&](const char* name, const std::vector<std::int64_t>& numbers) {
    return parseNumpy(npz({{name, npy("<i8", {numbers.size()}, numbers)}, {"points", points}}),
                      "a.npz");
  };
  expectNear(with("counts", counts), strands, 0, "counts");
  expectNear(with("num_points", counts), strands, 0, "counts of another name");
  expectNear(with("q", counts), strands, 0, "counts of no name");
  expectNear(with("offsets", offsets), strands, 0, "offsets");
  expectNear(with("indptr", offsets), strands, 0, "offsets of another name");
  expectNear(with("starts", starts), strands, 0, "offsets without the end");
  expectNear(with("split", ends), strands, 0, "ends");
  expectNear(with("strand_ids", ids), strands, 0, "a number a point");
  std::vector<std::uint8_t> small(counts.begin(), counts.end());
  expectNear(parseNumpy(npz({{"p", points}, {"counts", npy("|u1", {40}, small)}}), "a.npz"),
             strands, 0, "bytes");
  // Nothing says it: the spacing does.
  const StrandSet even = sampleGroom();
  const StrandFile cloud = parseNumpy(npy("<f4", {720, 3}, numbersOf<float>(even)), "a.npy");
  expectNear(cloud, even, 0, "a cloud");
  ASSERT_EQ(cloud.notes.size(), 1u);
  EXPECT_EQ(
      parseNumpy(npy("<f4", {720, 3}, numbersOf<float>(even)), "a.npy", 36).strands.strandCount(),
      20u);
}

TEST(Numpy, TheArrayOfPointsIsFoundAmongOthers) {
  const StrandSet strands = sampleGroom();
  const auto floats = numbersOf<float>(strands);
  const std::vector<float> roots(180, 0.5f), directions(2160, 0.25f);
  std::vector<std::uint8_t> colours(180);
  for (std::size_t i = 0; i < colours.size(); ++i) colours[i] = i < 3 ? 255 : 51;
  const StrandFile file =
      parseNumpy(npz({{"directions", npy("<f4", {60, 12, 3}, directions)},
                      {"roots", npy("<f4", {60, 3}, roots)},
                      {"hair_strands", npy("<f4", {60, 12, 3}, floats)},
                      {"radius", npy("<f4", {60}, std::vector<float>(60, 2e-5f))},
                      {"color", npy("|u1", {60, 3}, colours)},
                      {"meta", "no array"}}),
                 "a.npz");
  expectNear(file, strands, 0, "hair_strands");
  ASSERT_EQ(file.thickness.size(), strands.pointCount());
  EXPECT_FLOAT_EQ(file.thickness[700], 4e-5f);
  ASSERT_EQ(file.colours.size(), strands.pointCount());
  EXPECT_EQ(file.colours[11], glm::vec3(1));
  EXPECT_FLOAT_EQ(file.colours[12].y, 0.2f);
  ASSERT_EQ(file.notes.size(), 1u);
  EXPECT_NE(file.notes[0].find("hair_strands, radius, color are read"), std::string::npos)
      << file.notes[0];
  const TemporaryFolder folder;
  const auto path = folder.write("a.NPZ", npz({{"points", npy("<f4", {60, 12, 3}, floats)}}));
  EXPECT_EQ(readStrands(path, {0.01f, UpAxis::ZBack}).strands.points[0],
            0.01f * glm::vec3(floats[0], floats[2], -floats[1]));
  EXPECT_NE(errorOf([&] { writeStrands(folder / "b.npz", strands); }).find("read, not written"),
            std::string::npos);
}

// What is packed in kDynamic.
std::string packedText() {
  std::string words;
  for (int i = 0; i < 300; ++i) words += text("strand ", i * i % 97, " of ", i, "; ");
  return words;
}

const std::string kFixed = bytesFromHex("cb48cc2c52c840258af2f34b00");
const std::string kDynamic = bytesFromHex(
    "65985bce34270c44b7f22d019b8b41594da4288f89943ffb5734b832aeae7e8401ba30761d985ffffef3fb5f7ffc"
    "b49fbffffc69bffdfccaa67d9af66d8e4fd3bfcdf369f61abc3eedf16dfbfcb4e7b7ddefefab56bbf3e3db5e77f9"
    "fd6deffbf553f3af9812e777bc91bcb81d2530fc7694c46c97c49e1b2c8d2b4794c8733761a5b2a78c9219376656"
    "3aedaee12574de295e42cf8d8497d091912da1e70af3523a728d527a724a299d578797d27ddb2574ddad7809f51b"
    "af5e42f79dd24be8bc1fe925d4efde7a09dd990425745de59d8efd7eb69750cb1124f486a393d2ec28a5e30a1ba5"
    "b45f1da3945a8e28a5998c14d11bc05142f7d5354a68dcad8c121a39a28446aeb1b5e3c894d964d169f2d9e9226c"
    "f6a7f239646b73cae6e792f0cc9000ce2d219e470e613539a6657290cbe5a85797645843d2654d49a8b524e55648"
    "52aefdccda7524ada349e2874969844bf14497f28a210518534a349614718494796c3182386215bb89996c13bbd9"
    "fef4a3ddc5b0f6104bdb534c6fafa72bee10d7dc5b6df588ef9e26c67c4c9cfbb858fbe94feb3fe34986339fe038"
    "a5f206ef84fcbe65fe79ae6fad89026b2ad29acb3eac75d9aab521d1b0362560d696822694346d2b6ada51d6309f"
    "b2438fdf0850c00d110abc6146a51c821488639aad46989a98b525e78d4095656144aaac1c732d2e23561dccea52"
    "a246b4dad931a5cccdd5098c7985595bfcc41859207a1357b2aec66544adf436236c19c60c714823702df4a8cf1a"
    "a1ab43cf16b73682572e43f04ac7b7a15030c25772c30860813143e8638c30f4acd7ac78adbc5f5f3faa9038969b"
    "980a5c239021164432c48b58869812cc10f7a9f703239ce1fc88673863021af28088865c597a9d31665a2a64a865"
    "5e12d590bb8cb5ecd0bb9711d7502504365412a10dd5466c4345865e158de886ca26bca1fa896f7008021c5c24de"
    "37db503762c641e1115323c8c1f7f6eb1ace98cb6d11e870891eeac2443a38f5d6078311ece0f8443b5081700772"
    "10ef729923ef1a63de65477ff2cb08781831758da55f8997909758e25e6ec8097cb96927f065609cc097c1f326f1"
    "75e29e63d2946372e25ee0e112cfd3f6a609e1c4bd4c1a27ee656239830f0f20970475d3247602dfffcfa6a9ef26"
    "021f1e4e043ebc9c4c0bcf097c783bf1132df510f8f2f544dcc3f3c9d52a9cb98759532cc7197cb951065f1eb1ab"
    "bd39812f2dd0097c69934ee04b2b7502df428f5ab213f8d2b69dc06718b39eeeefc4bd048477858813f712344ee0"
    "4b1839812f81e50c3ef4f4d7acf15a79ead7097c5048e0cb4d0c45b513f7100be21ee245e0434c097c88fbd4eb85"
    "13f8707e043e9c31810f7940e043ae4cbd1239832f1532f8322ff92d975f67f065875ee29cb8f7ff3f0c532b89c0"
    "876a23f0a122975e3c9ddf74b90e810fd54fe0834310f8e022a1976527f0c18d187ca990c08721a1be177abd77e6"
    "5e6e8bc0976a887b7061e21e9c7aeb83c4097c707c7ee2e5ae087c8631f1848b6f794039632fffec694f8439510f"
    "235cd6d0579e33f552c8798925ee6143043e6cfae89bd43fe0fb0f");

TEST(Inflate, EveryKindOfBlock) {
  const std::string plain = packedText();
  EXPECT_EQ(inflate(kDynamic, plain.size(), "a.npz"), plain);
  EXPECT_EQ(inflate(kFixed, 24, "a.npz"), "hair hair hair hair root");
  const std::string stored = text(bytesFromHex("010500faff"), "tress");
  EXPECT_EQ(inflate(stored, 5, "a.npz"), "tress");
  EXPECT_EQ(inflate(bytesFromHex("00"
                                 "0100feff61") +
                        stored,
                    6, "a.npz"),
            "atress");
}

TEST(Inflate, DamageIsAnErrorOrOtherBytes) {
  const std::string plain = packedText();
  for (std::size_t cut = 0; cut < kDynamic.size(); ++cut)
    EXPECT_NE(errorOf([&] { inflate(kDynamic.substr(0, cut), plain.size(), "a.npz"); }), "") << cut;
  for (std::size_t i = 0; i < kDynamic.size(); ++i)
    for (int bit = 0; bit < 8; ++bit) {
      std::string damaged = kDynamic;
      damaged[i] = static_cast<char>(damaged[i] ^ (1 << bit));
      const std::string message =
          errorOf([&] { EXPECT_EQ(inflate(damaged, plain.size(), "a.npz").size(), plain.size()); });
      EXPECT_TRUE(message.empty() || message.starts_with("a.npz: the packed data ")) << message;
    }
  EXPECT_NE(errorOf([&] { inflate(kDynamic, plain.size() - 1, "a"); }).find("longer"),
            std::string::npos);
  EXPECT_NE(errorOf([&] { inflate(kDynamic, plain.size() + 1, "a"); }).find("shorter"),
            std::string::npos);
  EXPECT_NE(errorOf([&] { inflate("abc", std::size_t{1} << 40, "a"); }).find("too short"),
            std::string::npos);
}

TEST(Numpy, DamageIsAnError) {
  const StrandSet strands = sampleGroom({.strands = 3, .points = 4});
  const auto floats = numbersOf<float>(strands);
  const std::string good = npy("<f4", {3, 4, 3}, floats), zipped = npz({{"points", good}});
  const auto says = [](const std::string& bytes, const char* words) {
    const std::string message = errorOf([&] { parseNumpy(bytes, "a.npz"); });
    EXPECT_NE(message.find(words), std::string::npos) << message << " for " << words;
  };
  for (std::size_t cut = 0; cut < good.size(); ++cut)
    EXPECT_TRUE(errorOf([&] { parseNumpy(good.substr(0, cut), "a.npy"); }).starts_with("a.npy: "));
  for (std::size_t cut = 0; cut < zipped.size(); ++cut)
    EXPECT_TRUE(
        errorOf([&] { parseNumpy(zipped.substr(0, cut), "a.npz"); }).starts_with("a.npz: "));
  says("hello", "this is no .npy file");
  says(npy("|O", {3}, floats), "array of objects");
  says(npy("<c8", {3}, floats), "'<c8' is not read");
  says(npy("<f4", {9, 9, 9, 3}, floats), "announced");
  says(npy("<f4", {36}, floats), "no array of points");
  says(npy("<f4", {4294967296, 4294967296, 3}, floats), "beyond all files");
  says(npy("<f4", {12, 3}, floats).replace(10, 7, "{'descx"), "says nothing of descr");
  std::string sum = zipped;
  sum[sum.find("PK\x01\x02") + 16] ^= 1;
  says(sum, "check sum is wrong");
  std::string method = zipped;
  method[method.find("PK\x01\x02") + 10] = 12;
  says(method, "packed by method 12");
  says(npz({}), "holds no arrays");
}

}  // namespace
}  // namespace hair
