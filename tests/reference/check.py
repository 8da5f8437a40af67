"""Checks what the reference pictures rest on: `python check.py`; README.md beside this file.

1. The rough metal with the separable Smith term is Mitsuba's own, for any two directions.
2. With the height-correlated one and nothing absorbed, roughness 1 and light from straight above,
   1 - ln 2 of it comes back.
3. Its samples have its density: both ways of integrating agree.
4. Mitsuba starts rays a little off surfaces, by a length that grows with the coordinates. Ten times
   that length changes the pictures by so much.
5. With the separable Smith term the picture of the rough metals would be another: by so much.
"""

import math
import os
import tempfile

import mitsuba as mi
import numpy as np

mi.set_variant("llvm_ad_rgb")

import drjit as dr

import metal
from make import spread, standard_error
from scenes import COPPER, GOLD, SCENES, rgb

COUNT = 4_000_000


def directions(seed):
    sampler = mi.load_dict({"type": "independent"})
    sampler.seed(seed, COUNT)
    upper = lambda: mi.warp.square_to_uniform_hemisphere(sampler.next_2d())
    return sampler, upper(), upper()


def seen_from(wi):
    si = dr.zeros(mi.SurfaceInteraction3f, COUNT)
    si.wi = wi
    si.sh_frame = mi.Frame3f(mi.Normal3f(0, 0, 1))
    return si


def rough(alpha, eta_and_k, **rest):
    eta, k = eta_and_k
    return mi.load_dict({"type": "roughmetal", "alpha": alpha, "eta": eta, "k": k, **rest})


def worst(ours, theirs):
    """The largest difference, relative but for the smallest values."""
    ours, theirs = np.array(ours, dtype=np.float64), np.array(theirs, dtype=np.float64)
    return np.max(np.abs(ours - theirs) / (np.abs(theirs) + 1e-4))


def separable_is_mitsubas():
    context = mi.BSDFContext()
    sampler, wi, wo = directions(1)
    number, pair = sampler.next_1d(), sampler.next_2d()
    si = seen_from(wi)
    for alpha, (eta, k) in [(0.2, GOLD), (0.4, COPPER), (1.0, GOLD)]:
        ours = rough(alpha, (eta, k), correlated=False)
        theirs = {"type": "roughconductor", "distribution": "ggx", "alpha": alpha}
        theirs = mi.load_dict(theirs | {"eta": rgb(eta), "k": rgb(k)})
        # Both a direction at large and one that is sampled, where the lobe is.
        sampled, weight = theirs.sample(context, si, number, pair)
        own, own_weight = ours.sample(context, si, number, pair)
        good = (sampled.wo.z > 0) & (sampled.pdf > 0)
        kept = lambda value: dr.select(good, value, 0)
        errors = [
            worst(ours.eval(context, si, wo), theirs.eval(context, si, wo)),
            worst(*(kept(each.eval(context, si, sampled.wo)) for each in (ours, theirs))),
            worst(ours.pdf(context, si, wo), theirs.pdf(context, si, wo)),
            worst(kept(own.wo), kept(sampled.wo)),
            worst(kept(own_weight), kept(weight)),
        ]
        text = ", ".join(f"{error:.1e}" for error in errors)
        print(f"separable, alpha {alpha}: eval, in the lobe, pdf, direction, weight: {text}")


def nothing_absorbed():
    context = mi.BSDFContext()
    _, _, wo = directions(2)
    si = seen_from(mi.Vector3f(0, 0, 1))
    mirror = rough(1.0, GOLD, mirror=True)
    values = np.array(mirror.eval(context, si, wo))[0].astype(np.float64) * 2 * math.pi
    error = values.std() / math.sqrt(COUNT)
    print(f"1 - ln 2 = {1 - math.log(2):.6f}: {values.mean():.6f} +- {error:.6f}")


def samples_have_their_density():
    context = mi.BSDFContext()
    for alpha, height in [(0.2, 0.9), (0.4, 0.5), (0.4, 0.15)]:
        sampler, _, wo = directions(3)
        si = seen_from(mi.Vector3f(math.sqrt(1 - height * height), 0, height))
        metals = rough(alpha, COPPER)
        uniform = np.array(metals.eval(context, si, wo)).astype(np.float64) * 2 * math.pi
        _, weight = metals.sample(context, si, sampler.next_1d(), sampler.next_2d())
        weight = np.array(weight).astype(np.float64)
        error = np.hypot(uniform.std(axis=1), weight.std(axis=1)) / math.sqrt(COUNT)
        apart = (uniform.mean(axis=1) - weight.mean(axis=1)) / error
        print(f"albedo, alpha {alpha}, cosine {height}:", weight.mean(axis=1), "apart:", apart)


def compare(what, parts, others):
    """How far the tiles of two scenes are apart; the noise is that of the difference."""
    each, other = (spread(mi.load_dict(scene), 16, 1024, 5000)[0] for scene in (parts, others))
    change = other.mean(axis=0) / each.mean(axis=0) - 1
    error = np.hypot(standard_error(each), standard_error(other)) / each.mean(axis=0)
    worst = np.unravel_index(np.abs(change).argmax(), change.shape)
    print(
        f"{what}: mean change {100 * change.mean():.4f} %, largest {100 * change[worst]:.3f} %"
        f" +- {100 * error[worst]:.3f} % in tile {worst[1]},{worst[0]}",
        flush=True,
    )


def moved(part, away):
    """A scene's description, moved as a whole."""
    if not isinstance(part, dict):
        return part
    part = {key: moved(value, away) for key, value in part.items()}
    if part.get("type") in ("obj", "sphere", "perspective"):
        part["to_world"] = away @ part.get("to_world", mi.ScalarTransform4f())
    return part


def ray_offset(name, distance):
    away = mi.ScalarTransform4f().translate([distance] * 3)
    with tempfile.TemporaryDirectory() as folder:
        parts = SCENES[name](folder)
        compare(f"{name}, moved by {distance}", parts, moved(parts, away))


def separable_differs():
    with tempfile.TemporaryDirectory() as folder:
        parts = SCENES["rough-metals"](folder)
        shapes = {name: parts[name] for name in ("ball", "tall")}
        separable = {
            name: shape | {"bsdf": shape["bsdf"] | {"correlated": False}}
            for name, shape in shapes.items()
        }
        compare("rough-metals, separable", parts, parts | separable)


if __name__ == "__main__":
    metal.register()
    dr.set_thread_count(int(os.environ.get("THREADS", "2")))
    separable_is_mitsubas()
    nothing_absorbed()
    samples_have_their_density()
    ray_offset("cornell", 5000.0)
    ray_offset("rough-metals", 5000.0)
    ray_offset("bunny", 100.0)
    separable_differs()
