"""Time to an error of 0.005 on the Cornell box, beside Mitsuba 3: see docs/performance.md.

Each renderer is held against its own picture of many samples; errors are root mean squares of linear
radiance clamped to [0, 1], which takes the lamp's aliased edge out. Samples are the next square until
the error is small enough; the time is the median of some runs in turns, without start and building.
"""

import re
import statistics
import subprocess
import sys
import time
import tomllib
from pathlib import Path

import drjit as dr
import mitsuba as mi
import numpy as np

ERROR = 0.005
THREADS = 2
RUNS = 3
REFERENCE_SAMPLES = 1024
ROOT = Path(__file__).resolve().parents[2]
SCENE = ROOT / "benches" / "cornell.toml"
FOLDER = ROOT / "target" / "cornell"


def error(picture, reference):
    """The root mean square difference of two pictures clamped to [0, 1]."""
    difference = np.clip(picture, 0, 1) - np.clip(reference, 0, 1)
    return float(np.sqrt(np.mean(difference**2)))


class Groundtruth:
    """Our path tracer with one of our samplers, and the lamp sampled by area or by solid angle."""

    def __init__(self, sampler, sampling):
        self.name = f"groundtruth, {sampler}, {sampling}"
        text = SCENE.read_text()
        text = text.replace("[image]\n", f"[image]\nsampler.{sampler} = {{}}\n")
        text = text.replace('object = "lamp" }', f'object = "lamp", sampling = "{sampling}" }}')
        self.scene = FOLDER / f"{sampler}-{sampling}.toml"
        self.scene.write_text(text)

    def render(self, samples, seed):
        """The picture and the seconds it took."""
        output = FOLDER / "groundtruth.exr"
        command = [ROOT / "target/release/groundtruth", "render", self.scene, "-o", output]
        command += ["--samples", str(samples), "--seed", str(seed), "--threads", str(THREADS)]
        run = subprocess.run(command, check=True, capture_output=True, text=True)
        seconds = float(re.search(r"rendered in ([\d.]+) s", run.stderr).group(1))
        return np.array(mi.Bitmap(str(output)))[:, :, :3], seconds

    def reference(self):
        return self.render(REFERENCE_SAMPLES, 999)[0]


class Mitsuba:
    """Mitsuba's path tracer with one of its samplers, of the same scene."""

    def __init__(self, variant, sampler):
        self.name = f"Mitsuba {variant}, {sampler}"
        self.variant, self.sampler = variant, sampler
        self.use()
        self.scene = mi.load_dict(scene_of(tomllib.loads(SCENE.read_text())))

    def use(self):
        mi.set_variant(self.variant)

    def render(self, samples, seed):
        self.use()
        sensor = sensor_of(tomllib.loads(SCENE.read_text()), self.sampler, samples)
        start = time.perf_counter()
        picture = np.array(mi.render(self.scene, sensor=sensor, spp=samples, seed=seed))
        return picture[:, :, :3], time.perf_counter() - start

    def reference(self):
        pictures = [self.render(256, 1000 + i)[0] for i in range(REFERENCE_SAMPLES // 256)]
        return np.mean(pictures, axis=0)


def sensor_of(toml, sampler, samples):
    image, camera = toml["image"], toml["camera"]
    half = 0.5 * image["width"] * image["pixel_size"]
    fov = 2 * np.degrees(np.arctan(half / camera["lens"]["pinhole"]["distance"]))
    return mi.load_dict({
        "type": "perspective",
        "fov": fov,
        "to_world": mi.ScalarTransform4f().look_at(
            origin=camera["eye"], target=camera["look_at"], up=[0, 1, 0]
        ),
        "film": {
            "type": "hdrfilm",
            "width": image["width"],
            "height": image["height"],
            "rfilter": {"type": "box"},
            "pixel_format": "rgb",
            "component_format": "float32",
        },
        "sampler": {"type": sampler, "sample_count": samples},
    })


def scene_of(toml):
    colors = {
        material["name"]: material["recipe"]["matte"]["cd"]
        for material in toml["materials"]
        if "matte" in material["recipe"]
    }
    lamp = next(m["recipe"]["emissive"]["ce"] for m in toml["materials"] if m["name"] == "lamp")
    # an edge more than `max_depth` here: the camera's ray counts
    depth = toml["tracer"]["path"]["max_depth"] + 1
    scene = {"type": "scene", "integrator": {"type": "path", "max_depth": depth, "rr_depth": 5}}
    for thing in toml["objects"]:
        if "rectangle" in thing["shape"]:
            corner, a, b = (np.array(thing["shape"]["rectangle"][k]) for k in ("corner", "a", "b"))
            middle, normal = corner + (a + b) / 2, np.cross(a, b)
            columns = [a / 2, b / 2, normal / np.linalg.norm(normal), middle]
            matrix = np.vstack([np.column_stack(columns), [0, 0, 0, 1]])
            scene["lamp"] = {
                "type": "rectangle",
                "to_world": mi.ScalarTransform4f(matrix),
                "emitter": {"type": "area", "radiance": {"type": "rgb", "value": lamp}},
            }
        else:
            mesh = thing["shape"]["mesh"]
            color = {"type": "rgb", "value": colors[thing["material"]]}
            matte = {"type": "twosided", "bsdf": {"type": "diffuse", "reflectance": color}}
            file = FOLDER / f"{thing['name']}.ply"
            write_ply(file, mesh["vertices"], mesh["triangles"])
            scene[thing["name"]] = {
                "type": "ply", "filename": str(file), "face_normals": True, "bsdf": matte
            }
    return scene


def write_ply(file, vertices, triangles):
    lines = ["ply", "format ascii 1.0", f"element vertex {len(vertices)}"]
    lines += [f"property float {axis}" for axis in "xyz"]
    lines += [f"element face {len(triangles)}", "property list uchar int vertex_indices"]
    lines += ["end_header"]
    lines += [" ".join(map(str, vertex)) for vertex in vertices]
    lines += [" ".join(map(str, [3, *triangle])) for triangle in triangles]
    file.write_text("\n".join(lines) + "\n")


def main():
    FOLDER.mkdir(parents=True, exist_ok=True)
    samplers = ("hammersley", "area"), ("multi_jittered", "solid_angle")
    renderers = [Groundtruth(*pair) for pair in samplers]
    # llvm_ad_rgb runs with LLVM 19 (DRJIT_LIBLLVM_PATH), not with 14 to 16: name it on the command line
    for variant in ["scalar_rgb", *sys.argv[1:]]:
        mi.set_variant(variant)
        dr.set_thread_count(THREADS)
        renderers.append(Mitsuba(variant, "multijitter"))
    print(f"means of the references, then time to an error of {ERROR}, {THREADS} threads")
    references = {}
    for renderer in renderers:
        kind = renderer.name.split(",")[0]
        if kind not in references:
            references[kind] = renderer.reference()
            print(f"{kind}: mean {np.clip(references[kind], 0, 1).mean():.5f}", flush=True)
    found = []
    for renderer in renderers:
        reference, samples, off = references[renderer.name.split(",")[0]], 4, 1.0
        while off > ERROR:
            samples = (int(np.sqrt(samples)) + 1) ** 2
            off = error(renderer.render(samples, 1)[0], reference)
        found.append((renderer, samples, off))
    times = {renderer.name: [] for renderer in renderers}
    for run in range(RUNS):
        for renderer, samples, _ in found:
            times[renderer.name].append(renderer.render(samples, 2 + run)[1])
    for renderer, samples, off in found:
        seconds = statistics.median(times[renderer.name])
        rate = 256 * 256 * samples / seconds / 1e6
        # the variance falls about as 1/samples
        exactly = seconds * (off / ERROR) ** 2
        print(
            f"{renderer.name:42} {samples:5} samples, error {off:.5f}, {seconds:6.2f} s, "
            f"{exactly:.2f} s to {ERROR}, {rate:.2f} million paths a second"
        )


if __name__ == "__main__":
    sys.exit(main())
