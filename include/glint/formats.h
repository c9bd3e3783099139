#pragma once
// All kinds of files: scenes, meshes, pictures, explanations.

#include "glint/explanation_files.h"
#include "glint/mesh_files.h"
#include "glint/picture_files.h"
#include "glint/scene_files.h"
#include "glint/write_file.h"
