"""Pictures of Mitsuba's Cornell box: 64 by 64 pixels, 16 paths in each; one for each seed, as SEED.exr in the working folder."""

import sys

import mitsuba as mi

mi.set_variant("scalar_rgb")
description = mi.cornell_box()
description["sensor"]["film"].update(width=64, height=64, rfilter={"type": "box"})
scene = mi.load_dict(description)
for seed in range(int(sys.argv[1])):
    mi.util.write_bitmap(f"{seed}.exr", mi.render(scene, seed=seed, spp=16))
