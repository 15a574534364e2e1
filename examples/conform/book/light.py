"""BRDFs and BTDFs (ch. 13, 15, 24 to 28), Fresnel's equations (ch. 28), and lights (ch. 14 and 18).

In a `lobe`, the normal is n = (0, 0, 1). A reflectance is the book's product of coefficient and colour, as kd·cd."""
import math

from numbers_as_in_c import add, along, cross, dot, in_frame, root, sub, times, unit
from samplers import to_disk, to_hemisphere, to_sphere
from unsupported import Unsupported

INV_PI = 0.3183098861837906715
N = [0.0, 0.0, 1.0]


def mirrored(w, n):
    """−w + 2 (n·w) n."""
    return [-x + 2 * dot(n, w) * y for x, y in zip(w, n)]


def lambertian(data, q, answer):
    """f = kd cd / π and ρ = kd cd (ch. 13); drawn with density cos θ / π (ch. 26)."""
    answer["albedo"] = data["reflectance"]
    f = times(INV_PI, data["reflectance"])
    if "wi" in q:
        answer.update(f=f, pdf=dot(N, q["wi"]) * INV_PI)
    if "u" in q:
        v = unit(cross([0.0034, 1, 0.0071], N))
        wi = in_frame(to_hemisphere(q["u"], 1), cross(v, N), v, N)
        answer["sample"] = drawn(wi, f, dot(N, wi) * INV_PI)


def glossy_specular(data, q, answer):
    """f = ks cs (r·wo)^e, without a factor of e (ch. 15)."""
    if "u" in q:
        raise Unsupported("directions of highlights: those of glossy_reflection (ch. 25)")
    cosine = dot(mirrored(q["wi"], N), q["wo"])
    answer["f"] = times(cosine ** data["exponent"] if cosine > 0 else 0.0, data["reflectance"])


def glossy_reflection(data, q, answer):
    """Around the mirror direction (ch. 25). As printed, f has no factor of e, and the pdf is the lobe times n·wi, which is
    no density: its integral is not 1. Both cancel in what the light along the ray counts, ks cs."""
    if data["rule"] != "book":
        raise Unsupported("a normalised lobe")
    r = mirrored(q["wo"], N)

    def values(wi):
        lobe = max(dot(r, wi), 0.0) ** data["exponent"]
        return times(lobe, data["reflectance"]), lobe * dot(N, wi)

    if "wi" in q:
        answer["f"], answer["pdf"] = values(q["wi"])
    if "u" in q:
        u = unit(cross([0.00424, 1, 0.00764], r))
        x, y, z = to_hemisphere(q["u"], data["exponent"])
        wi = in_frame([x, y, z], u, cross(u, r), r)
        if dot(N, wi) < 0:
            wi = in_frame([-x, -y, z], u, cross(u, r), r)
        answer["sample"] = drawn(wi, *values(wi))


def drawn(wi, f, pdf):
    return {"wi": wi, "weight": [x * abs(dot(N, wi)) / pdf for x in f], "pdf": pdf}


def perfect_specular(data, q, answer):
    """f = kr cr / |n·wi| (ch. 24)."""
    wi = mirrored(q["wo"], N)
    answer["sample"] = drawn(wi, times(1 / abs(dot(N, wi)), data["reflectance"]), 1.0)


def perfect_transmitter(data, q, answer):
    """f = kt / η² / |n·wt| (ch. 27)."""
    wt = refracted(q["wo"], N, data["eta"])
    kt = data["transmittance"]
    answer["sample"] = wt and drawn(wt, [kt / (data["eta"] * data["eta"]) / abs(dot(N, wt))] * 3, 1.0)


def fresnel_reflector(data, q, answer):
    """f = kr / |n·wi|, and all of the light on total internal reflection (ch. 28)."""
    wi = mirrored(q["wo"], N)
    kr = shares(dot(N, q["wo"]), data["eta"])[0]
    answer["sample"] = drawn(wi, [kr / abs(dot(N, wi))] * 3, 1.0)


def fresnel_transmitter(data, q, answer):
    """f = kt / η² / |n·wt| (ch. 28)."""
    eta, wt = data["eta"], refracted(q["wo"], N, data["eta"])
    kt = 1 - shares(dot(N, q["wo"]), eta)[0]
    answer["sample"] = wt and drawn(wt, [kt / (eta * eta) / abs(dot(N, wt))] * 3, 1.0)


LOBES = {f.__name__: f for f in (lambertian, glossy_specular, glossy_reflection, perfect_specular, perfect_transmitter,
                                 fresnel_reflector, fresnel_transmitter)}


def lobe(q):
    (kind, data), = q["lobe"].items()
    if kind not in LOBES:
        raise Unsupported(kind)
    if "wi" not in q and "u" not in q and kind != "lambertian":
        raise Unsupported("an albedo: ρ is black in all other BRDFs, for ambient light alone has a use for it")
    answer = {}
    LOBES[kind](data, q, answer)
    return answer


def cos_t_squared(cos_i, eta):
    """Negative on total internal reflection (ch. 27)."""
    return 1 - (1 - cos_i * cos_i) / (eta * eta)


def refracted(wo, n, eta):
    """wt = −wo/η − (cos θt − cos θi/η) n (ch. 27)."""
    cos_i = dot(n, wo)
    square = cos_t_squared(cos_i, eta)
    if square < 0:
        return None
    return [-x / eta - (root(square) - cos_i / eta) * y for x, y in zip(wo, n)]


def shares(cos_i, eta):
    """What is reflected: kr, then the squares of r⊥ and r∥ (ch. 28)."""
    square = cos_t_squared(cos_i, eta)
    if square < 0:
        return 1.0, 1.0, 1.0
    cos_t = root(square)
    parallel = (eta * cos_i - cos_t) / (eta * cos_i + cos_t)
    perpendicular = (cos_i - eta * cos_t) / (cos_i + eta * cos_t)
    r_s, r_p = perpendicular * perpendicular, parallel * parallel
    return 0.5 * (r_p + r_s), r_s, r_p


def fresnel(q):
    kr, r_s, r_p = shares(dot(q["n"], q["wo"]) if "wo" in q else q["cos_i"], q["eta"])
    answer = {"reflected": kr, "transmitted": 1 - kr, "r_s": r_s, "r_p": r_p}
    if "wo" in q:
        answer["refracted"] = refracted(q["wo"], q["n"], q["eta"])
    return answer


def light(q):
    (kind, data), = q["light"].items()
    radiance = times(data.get("ls", 1), data.get("color", [1, 1, 1]))
    if kind == "ambient":
        return {"ambient": radiance}
    if kind == "directional":
        return {"direction": unit(data["direction"]), "distance": math.inf, "radiance": radiance}
    if kind == "point" and not data.get("attenuation"):
        to_light = sub(data["location"], q["from"])
        return {"direction": unit(to_light), "distance": root(dot(to_light, to_light)), "radiance": radiance}
    if kind == "area":
        return area_light(q)
    raise Unsupported(kind)


def area_light(q):
    """A point of the lamp, equally likely everywhere (ch. 18); the back of the lamp is dark. The book's pdf 1/A counts areas
    of the lamp and comes with G = cos θ / d²: over G it is the pdf of the direction."""
    if q["light"]["area"].get("sampling") != "area":
        raise Unsupported("the book samples lamps by area")
    if q["lamp"].get("two_sided"):
        raise Unsupported("the book's lamps shine from one side")
    point, normal, area = sample(q["lamp"]["shape"], q["u"][0])
    to_light = sub(point, q["from"])
    wi = unit(to_light)
    if -dot(normal, wi) <= 0:
        return None
    emissive = q["lamp"]["material"]["emissive"]
    if isinstance(emissive.get("ce"), dict):
        raise Unsupported("textured emission")
    radiance = times(emissive.get("ls", 1), emissive.get("ce", [1, 1, 1]))
    g = -dot(normal, wi) / dot(to_light, to_light)
    distance = root(dot(to_light, to_light))
    return {"direction": wi, "distance": distance, "radiance": radiance, "pdf": 1 / area / g}


def sample(shape, u):
    """A point of the shape, the normal there, and the area."""
    (kind, s), = shape.items()
    if kind == "rectangle":
        point = add(add(s["corner"], times(u[0], s["a"])), times(u[1], s["b"]))
        across = cross(s["a"], s["b"])
        return point, unit(across), root(dot(across, across))
    if kind == "disk":
        w = unit(s["normal"])
        across = unit(cross([0.0034, 1, 0.0071], w))
        x, y = to_disk(u)
        point = add(s["center"], times(s["radius"], in_frame([x, y, 0], across, cross(w, across), w)))
        return point, w, math.pi * s["radius"] ** 2
    if kind == "sphere":
        normal = to_sphere(u)
        return along(s["center"], s["radius"], normal), normal, 4 * math.pi * s["radius"] ** 2
    raise Unsupported(f"a lamp that is a {kind}")
