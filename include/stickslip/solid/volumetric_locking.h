#ifndef stickslip_solid_volumetric_locking_h
#define stickslip_solid_volumetric_locking_h

#include <stickslip/base/parameter_file.h>

#include <stickslip/mesh/body.h>

#include <stickslip/solid/material_parameters.h>

#include <string>
#include <vector>

namespace stickslip
{
  /**
   * Warnings about materials that hardly change their volume (a Poisson's ratio
   * above 0.4, plastic flow) on linear triangles or tetrahedra: these have one
   * change of volume per cell, too many for their few nodes, and F-bar and
   * B-bar average over a cell what is constant there. Plane stress does not
   * lock.
   */
  std::vector<std::string>
  warnings_about_locking(const NamedList<MaterialParameters> &materials,
                         const Bodies                        &bodies,
                         const unsigned int                   degree);
} // namespace stickslip

#endif
