#pragma once

#include <string_view>

namespace hair {

/// A reader each, fed with any bytes: it either reads what it promises or throws Error, which
/// is caught here; anything else is a defect. Shared by the fuzzers and the ordinary tests.
/// True where the bytes were read.

bool fuzzHair(std::string_view bytes);
bool fuzzTfx(std::string_view bytes);
bool fuzzData(std::string_view bytes);
bool fuzzPly(std::string_view bytes);
/// An OBJ file as strands.
bool fuzzLines(std::string_view bytes);
/// Every frame of it.
bool fuzzUsda(std::string_view bytes);
/// A .npy or .npz file.
bool fuzzNumpy(std::string_view bytes);
bool fuzzPbrt(std::string_view bytes);
bool fuzzBvh(std::string_view bytes);
bool fuzzObj(std::string_view bytes);
/// A hair mesh.
bool fuzzMesh(std::string_view bytes);
/// A script that makes one; the only file it finds is a scalp of two faces.
bool fuzzScript(std::string_view bytes);
/// A .bvh file as what it is for: a body that moves.
bool fuzzClip(std::string_view bytes);

/// A saved state of a hair that is what it was saved of (SmallHair): as it is, and with its check
/// sum put right. True where either was restored. (state_target.cpp)
bool fuzzState(std::string_view bytes);

/// The command line of a program up to its work: a line a word, `hair` or `dance` the first. True
/// where it was understood. (options_target.cpp)
bool fuzzOptions(std::string_view lines);

}  // namespace hair
