#pragma once

/// A header is public where its namespace says `namespace HAIR_API hair`: it is installed and
/// documented, and what it declares is visible in the shared library. All else is hidden and may
/// change at any time.
#if defined(_MSC_VER)
#define HAIR_API  // no attribute of namespaces there: the static library only
#else
#define HAIR_API [[gnu::visibility("default")]]
#endif
