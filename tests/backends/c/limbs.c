/* Elements of limbs are those of the robot that begin with the name of the limb. */
#include <in_c_hexapod_c/in_c_hexapod_c.h>
#include <stdio.h>
#include <string.h>

static int count_wrong(const char* limb, const in_c_hexapod_limb_element* elements, const char* const* names) {
  int wrong = 0;
  char expected[100];
  for (; elements->own; ++elements) {
    /* The frame fr_foot of the limb LF is fr_LF_foot. */
    const int is_frame = strncmp(elements->own, "fr_", 3) == 0;
    snprintf(expected, sizeof expected, "%s%s_%s", is_frame ? "fr_" : "", limb, elements->own + (is_frame ? 3 : 0));
    if (strcmp(names[elements->index], expected) == 0) continue;
    printf("%s is not %s\n", names[elements->index], expected);
    ++wrong;
  }
  return wrong;
}

static int count(const in_c_hexapod_limb_element* elements) {
  int n = 0;
  while (elements[n].own) ++n;
  return n;
}

int main(void) {
  int limbs = 0, joints = 0, frames = 0, wrong = 0;
  const in_c_hexapod_limb* limb;
  for (limb = in_c_hexapod_limbs; limb->name; ++limb) {
    ++limbs;
    joints += count(limb->joints);
    frames += count(limb->frames);
    wrong += count_wrong(limb->name, limb->links, in_c_hexapod_link_names);
    wrong += count_wrong(limb->name, limb->joints, in_c_hexapod_joint_names);
    wrong += count_wrong(limb->name, limb->frames, in_c_hexapod_frame_names);
    wrong += limb->first_link != limb->links[0].index || strcmp(limb->part, "Leg") != 0;
  }
  return wrong || limbs != 6 || joints != in_c_hexapod_dof || frames != 12;
}
