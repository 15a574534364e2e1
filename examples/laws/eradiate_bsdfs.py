#!/usr/bin/env python3
"""The BSDFs that Eradiate's kernel adds to Mitsuba's (in single precision) answer `groundtruth laws`: soils, canopies and
oceans of remote sensing.

Needs: pip install eradiate-mitsuba, in an environment without Mitsuba, whose name it has
Run: groundtruth laws -- python3 examples/laws/eradiate_bsdfs.py"""
import init
import mitsuba_bsdfs as adapter

COLOR = [0.1, 1]
REFLECTS = adapter.REFLECTS
# as their documentation chooses them
init.LOBES = [
    {"name": name, "parameters": parameters, "claims": claims} for name, parameters, claims in [
        ("bilambertian", {"reflectance": [0.1, 0.5], "transmittance": [0.1, 0.5]},
         {**REFLECTS, "sides": "both", "from_below": True}),
        ("rpv", {"rho_0": [0.05, 0.2], "k": [0.5, 1], "g": [-0.3, 0.1]}, REFLECTS),
        ("rtls", {"f_iso": [0.1, 0.3], "f_vol": [0, 0.2], "f_geo": [0, 0.05]}, REFLECTS),
        ("hapke", {"w": [0.1, 0.9], "b": [0.1, 0.4], "c": [0, 0.5], "theta": [0, 30], "B_0": [0, 1], "h": [0.05, 0.3]},
         REFLECTS),
        ("ocean_legacy", {"wavelength": 550, "wind_speed": [1, 15], "wind_direction": 0, "chlorinity": 19,
                          "pigmentation": 0.3}, {"float": True}),
        ("ocean_mishchenko", {"wind_speed": [1, 15]}, REFLECTS),
        ("maignan", {"C": [1, 10], "ndvi": [0, 1]}, REFLECTS),
    ]
]
adapter.described = lambda name, parameters: {"type": name, **parameters}

if __name__ == "__main__":
    init.main()
