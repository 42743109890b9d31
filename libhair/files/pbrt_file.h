#pragma once

#include <string_view>

#include <libhair/files/strand_file.h>

namespace hair {

/// Strands from a scene of pbrt (pbrt.org/fileformat-v4; version 3 too): its `Shape "curve"`, of
/// basis bezier or bspline and degree 2 or 3, with `width` or `width0` and `width1`, under
/// Identity, Translate, Scale, Rotate, Transform, ConcatTransform, LookAt, and the blocks that keep
/// them (AttributeBegin, TransformBegin, ObjectBegin). Curves of which each begins where the one
/// before ends are one strand. Cubic curves become points as in .usda (usda_curves.h). All else is
/// skipped; included files are not followed, instances are where their objects are. Metres, +Y up.
/// Throws Error (file, line, cause).
StrandFile parsePbrt(std::string_view bytes, std::string_view name);

}  // namespace hair
