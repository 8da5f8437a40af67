"""Makes the reference pictures: `python make.py [SCENE...]`; README.md beside this file says how.

For each scene it writes SCENE.exr, the mean of many pictures, each of its own seed, and SCENE.csv,
the mean over tiles of 8 x 8 pixels with the standard error that the pictures' spread gives.
"""

import datetime
import os
import platform
import sys
import tempfile
import time

import mitsuba as mi
import numpy as np

VARIANT = "llvm_ad_rgb"
mi.set_variant(VARIANT)

import drjit as dr

import metal
from scenes import SCENES, SIZE

HERE = os.path.dirname(os.path.abspath(__file__))
TILE = 8
SPP = 1024
DEFAULT_PASSES = 64
PASSES = {"cornell-glass": 256, "many-lights": 256, "sphere-light": 128, "rough-metals": 128}


def tiles(picture):
    """The means over tiles: rows, columns, channels."""
    count = SIZE // TILE
    return picture.reshape(count, TILE, count, TILE, 3).mean(axis=(1, 3))


def spread(scene, passes, spp, first_seed):
    """The tiles of every pass, and the mean of all pictures."""
    total, each = np.zeros((SIZE, SIZE, 3)), []
    squares = np.zeros_like(total)
    for seed in range(first_seed, first_seed + passes):
        picture = np.array(mi.render(scene, spp=spp, seed=seed)).astype(np.float64)
        total += picture
        squares += picture * picture
        each.append(tiles(picture))
    mean = total / passes
    variance = (squares / passes - mean * mean) / (passes - 1)
    return np.array(each), mean, np.sqrt(variance.mean())


def standard_error(each):
    """Of the mean; never less than rounding: sums of equal numbers in single
    precision, as where only sky is seen, are wrong by about 1e-5."""
    return np.maximum(each.std(axis=0, ddof=1) / np.sqrt(len(each)), 2e-5 * each.mean(axis=0))


def write_csv(path, name, passes, mean, error):
    with open(path, "w", newline="\n") as out:
        out.write(f"# scene {name}, {SIZE}x{SIZE}, in tiles of {TILE}x{TILE} from the top left\n")
        made = f"Mitsuba {mi.__version__} ({VARIANT}), {passes} seeds x {SPP} samples a pixel"
        out.write(f"# {made}\n")
        out.write(f"# {datetime.date.today()}, linear RGB, standard error over the seeds\n")
        out.write("tile_x,tile_y,r,g,b,r_error,g_error,b_error\n")
        for y, row in enumerate(mean):
            for x, color in enumerate(row):
                means = [f"{part:.8g}" for part in color]
                errors = [f"{part:.3g}" for part in error[y, x]]
                out.write(",".join([str(x), str(y), *means, *errors]) + "\n")


def report(name, scene, each, picture_error, seconds):
    """What README.md says of a scene, on one line."""
    mean, error = each.mean(axis=0), standard_error(each)
    relative = error / mean
    half = len(each) // 2
    first, second = each[:half], each[half:]
    apart = (first.mean(axis=0) - second.mean(axis=0)) / np.hypot(
        standard_error(first), standard_error(second)
    )
    # A sixteenth of the samples a pass must scatter four times as much.
    few = spread(scene, DEFAULT_PASSES, SPP // 16, 1_000_000)[0]
    noisy = relative > 2e-5
    scatter = np.median(few.std(axis=0, ddof=1)[noisy] / each.std(axis=0, ddof=1)[noisy])
    print(
        f"| {name} | {len(each)} x {SPP} | {100 * relative.max():.3f} % |"
        f" {100 * np.median(relative):.3f} % | {picture_error:.2g} |"
        f" {scatter:.2f} | {np.sqrt((apart**2).mean()):.2f} | {seconds:.0f} s |",
        flush=True,
    )


def main():
    metal.register()
    dr.set_thread_count(int(os.environ.get("THREADS", "2")))
    for name in sys.argv[1:] or SCENES:
        with tempfile.TemporaryDirectory() as folder:
            scene = mi.load_dict(SCENES[name](folder))
        passes = PASSES.get(name, DEFAULT_PASSES)
        start = time.time()
        each, mean, picture_error = spread(scene, passes, SPP, 1)
        seconds = time.time() - start
        mi.Bitmap(mean.astype(np.float32)).write(os.path.join(HERE, name + ".exr"))
        path = os.path.join(HERE, name + ".csv")
        write_csv(path, name, passes, each.mean(axis=0), standard_error(each))
        report(name, scene, each, picture_error, seconds)


if __name__ == "__main__":
    print(f"{platform.machine()}, Python {platform.python_version()}", file=sys.stderr)
    main()
