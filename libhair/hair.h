#pragma once

// What a program that simulates and shadows hair needs, in the order that data flows. Headers of
// one stage, of hair meshes (libhair/hair_mesh/) and of measurements (libhair/measure/) are
// included by themselves; those that declare something under HAIR_API are public, and this one is.

#include <libhair/core/api.h>
#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/core/strands.h>
#include <libhair/files/strand_file.h>
#include <libhair/files/strand_sequence.h>
#include <libhair/geometry/mesh_sdf.h>
#include <libhair/model/head.h>
#include <libhair/model/styles.h>
#include <libhair/motion/motion.h>
#include <libhair/simulation/simulation.h>
#include <libhair/wisps/bind.h>
#include <libhair/wisps/load_groom.h>
