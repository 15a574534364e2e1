"""Renders scenes of Mitsuba: render.py SCENE.xml PICTURE.exr ...; prints the version.

Each picture has another seed.
"""

import sys

import mitsuba as mi

mi.set_variant("scalar_rgb")
print(f"Mitsuba {mi.__version__} ({mi.variant()})")
for index in range(1, len(sys.argv), 2):
    scene, picture = sys.argv[index : index + 2]
    image = mi.render(mi.load_file(scene), seed=index)
    mi.Bitmap(image).write(picture)
