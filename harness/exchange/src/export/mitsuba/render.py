"""Renders a scene of Mitsuba: render.py SCENE.xml PICTURE.exr; prints the version."""

import sys

import mitsuba as mi

mi.set_variant("scalar_rgb")
print(f"Mitsuba {mi.__version__} ({mi.variant()})")
scene, picture = sys.argv[1:]
mi.Bitmap(mi.render(mi.load_file(scene), seed=1)).write(picture)
