"""The scenes, written down for Mitsuba: nothing here is taken from the project's Rust code.

Every mesh is a list of triangles, so that walls whose four corners aren't in one plane (the red
one) are divided in the same way as the project divides them: a, b, c and a, c, d.
"""

import os

import numpy as np

BUNNY = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "assets", "bunny.obj")
SIZE = 32

# Johnson and Christy (1972), as chapter 7 has them: n and k for red, green and blue.
GOLD = ([0.14, 0.43, 1.38], [3.697, 2.455, 1.914])
COPPER = ([0.22, 1.02, 1.24], [3.747, 2.577, 2.397])

CEILING_LIGHT = [
    8 * (0.747 + 0.058) + 15.6 * (0.740 + 0.287) + 18.4 * (0.737 + 0.642),
    8 * (0.747 + 0.258) + 15.6 * (0.740 + 0.160) + 18.4 * (0.737 + 0.159),
    8 * 0.747 + 15.6 * 0.740 + 18.4 * 0.737,
]


def rgb(color):
    return {"type": "rgb", "value": [float(part) for part in color]}


def matte(*color):
    """Lambert's law, on both sides."""
    return {"type": "twosided", "bsdf": {"type": "diffuse", "reflectance": rgb(color)}}


WHITE = matte(0.725, 0.71, 0.68)
RED = matte(0.63, 0.065, 0.05)
GREEN = matte(0.14, 0.45, 0.091)
MIRROR = {"type": "conductor", "material": "none", "specular_reflectance": rgb([0.9] * 3)}
GLASS = {"type": "dielectric", "int_ior": 1.5, "ext_ior": 1.0}


def metal(alpha, eta_and_k):
    eta, k = eta_and_k
    return {"type": "roughmetal", "alpha": alpha, "eta": eta, "k": k}


def glowing(radiance):
    """A surface that reflects nothing and glows on the side its corners turn left on."""
    return {
        "bsdf": {"type": "diffuse", "reflectance": rgb([0, 0, 0])},
        "emitter": {"type": "area", "radiance": rgb(radiance)},
    }


def quads(folder, name, faces, **rest):
    """A mesh of four-cornered faces, with flat normals. Mitsuba reads meshes from files only."""
    path = os.path.join(folder, name + ".obj")
    with open(path, "w") as out:
        for face in faces:
            out.writelines("v {:.9g} {:.9g} {:.9g}\n".format(*corner) for corner in face)
        for first in range(1, 4 * len(faces), 4):
            out.write(f"f {first} {first + 1} {first + 2}\nf {first} {first + 2} {first + 3}\n")
    return {"type": "obj", "filename": path, "face_normals": True, **rest}


def camera(eye, target, fov):
    import mitsuba as mi

    film = {"type": "hdrfilm", "width": SIZE, "height": SIZE, "pixel_format": "rgb"}
    film |= {"component_format": "float32", "rfilter": {"type": "box"}}
    return {
        "type": "perspective",
        "fov": fov,
        "fov_axis": "y",
        "to_world": mi.ScalarTransform4f().look_at(origin=eye, target=target, up=[0, 1, 0]),
        "film": film,
        "sampler": {"type": "independent"},
    }


def scene(eye, target, fov, **shapes):
    # Paths have no limit. Russian roulette from the eighth bounce on leaves the mean as it is.
    integrator = {"type": "path", "max_depth": -1, "rr_depth": 8}
    return {"type": "scene", "integrator": integrator, "sensor": camera(eye, target, fov), **shapes}


def box(folder, **content):
    """The room, without light and blocks, and its camera: THE REPORT, figure 5.6."""
    white = [
        [[552.8, 0, 0], [0, 0, 0], [0, 0, 559.2], [549.6, 0, 559.2]],
        [[556, 548.8, 0], [556, 548.8, 559.2], [0, 548.8, 559.2], [0, 548.8, 0]],
        [[549.6, 0, 559.2], [0, 0, 559.2], [0, 548.8, 559.2], [556, 548.8, 559.2]],
    ]
    green = [[[0, 0, 559.2], [0, 0, 0], [0, 548.8, 0], [0, 548.8, 559.2]]]
    red = [[[552.8, 0, 0], [549.6, 0, 559.2], [556, 548.8, 559.2], [556, 548.8, 0]]]
    walls = {
        "white": quads(folder, "white", white, bsdf=WHITE),
        "green": quads(folder, "green", green, bsdf=GREEN),
        "red": quads(folder, "red", red, bsdf=RED),
    }
    return scene([278, 273, -800], [278, 273, 0], 40, **walls, **content)


def ceiling_light(folder):
    corners = [[343, 548.7, 227], [343, 548.7, 332], [213, 548.7, 332], [213, 548.7, 227]]
    return quads(folder, "light", [corners], **glowing(CEILING_LIGHT))


def block(folder, name, height, top, bsdf):
    """Top and sides; their corners run counter-clockwise seen from outside."""
    at = lambda corner, y: [top[corner % 4][0], y, top[corner % 4][1]]
    faces = [[at(corner, height) for corner in range(4)]]
    for side in range(4):
        faces.append([at(side, height), at(side, 0), at(side + 1, 0), at(side + 1, height)])
    return quads(folder, name, faces, bsdf=bsdf)


def short_block(folder, bsdf):
    return block(folder, "short", 165, [[130, 65], [82, 225], [240, 272], [290, 114]], bsdf)


def tall_block(folder, bsdf):
    return block(folder, "tall", 330, [[423, 247], [265, 296], [314, 456], [472, 406]], bsdf)


def ball(center, radius, **rest):
    return {"type": "sphere", "center": center, "radius": radius, **rest}


def two_blocks(folder):
    return {"short": short_block(folder, WHITE), "tall": tall_block(folder, WHITE)}


def cornell(folder):
    return box(folder, light=ceiling_light(folder), **two_blocks(folder))


def cornell_glass(folder):
    content = {"ball": ball([185, 90, 169], 90, bsdf=GLASS), "tall": tall_block(folder, MIRROR)}
    return box(folder, light=ceiling_light(folder), **content)


def sphere_light(folder):
    light = ball([278, 420, 280], 60, **glowing([10, 10, 10]))
    return box(folder, light=light, **two_blocks(folder))


def many_lights(folder):
    tints = [[1, 0.9, 0.7], [0.8, 0.9, 1], [1, 1, 1]]
    lights = {}
    for i in range(8):
        for j in range(8):
            x, z, y = 33 + 70 * i, 35 + 70 * j, 548.7
            corners = [[x + 6, y, z - 6], [x + 6, y, z + 6], [x - 6, y, z + 6], [x - 6, y, z - 6]]
            strength = 40 * (1 + (3 * i + 5 * j) % 7)
            emission = glowing([strength * part for part in tints[(i + j) % 3]])
            lights[f"light{i}{j}"] = quads(folder, f"light{i}{j}", [corners], **emission)
    return box(folder, **lights, **two_blocks(folder))


def bunny(folder):
    rows = [line.split() for line in open(BUNNY) if line.startswith("v ")]
    points = np.array([[float(part) for part in row[1:]] for row in rows], dtype=np.float32)
    low, high = points.min(axis=0), points.max(axis=0)
    (x, _, z), y = (low + high) / 2, low[1]
    corners = [[x - 20, y, z + 20], [x + 20, y, z + 20], [x + 20, y, z - 20], [x - 20, y, z - 20]]
    mesh = {"type": "obj", "filename": BUNNY, "face_normals": True}
    content = {
        "bunny": {**mesh, "bsdf": matte(0.7, 0.5, 0.3)},
        "floor": quads(folder, "floor", [corners], bsdf=matte(0.5, 0.5, 0.5)),
        "sky": {"type": "constant", "radiance": rgb([0.7, 0.8, 1.0])},
    }
    return scene([-1, 5, 10], [-1, 5, 0], 90, **content)


def rough_metals(folder):
    content = {
        "ball": ball([185, 90, 169], 90, bsdf=metal(0.4, COPPER)),
        "tall": tall_block(folder, metal(0.2, GOLD)),
    }
    return box(folder, light=ceiling_light(folder), **content)


SCENES = {
    "cornell": cornell,
    "cornell-glass": cornell_glass,
    "sphere-light": sphere_light,
    "many-lights": many_lights,
    "bunny": bunny,
    "rough-metals": rough_metals,
}
