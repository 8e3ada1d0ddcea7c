#!/bin/sh
# Writes the small closed models cube.obj, tetrahedron.obj, torus.obj and icosphere.obj:
#
#     scripts/make-models.sh [FOLDER]             # examples/models if no folder is given
#     scripts/make-models.sh torus [RINGS SIDES]  # a torus of any size, to standard output
#     scripts/make-models.sh head [RINGS SIDES]   # a head, its mouth behind its lips
#
# y points up, and every face is counter-clockwise seen from outside (x right, z toward the viewer).
# A torus has RINGS x SIDES quads, that is twice as many triangles; a head has its rings from chin to crown,
# and two triangles a side fewer, at its ends. Exit status: 0 fine, 2 bad usage.
set -eu
export LC_ALL=C

usage() {
    echo "usage: scripts/make-models.sh [FOLDER]" >&2
    echo "       scripts/make-models.sh torus|head [RINGS SIDES]    (each from 3 to 10000)" >&2
    exit 2
}

# model NAME [RINGS SIDES]: the model as OBJ text.
model() {
    awk -v name="$1" -v rings="${2:-0}" -v sides="${3:-0}" '
    # Six places, and no minus sign in front of zero.
    function fixed(value,    text) {
        text = sprintf("%.6f", value)
        return text == "-0.000000" ? "0.000000" : text
    }

    function vertex(x, y, z) {
        printf "v %s %s %s\n", fixed(x), fixed(y), fixed(z)
    }

    # A face of the vertices in a list like "1 2 3".
    function face(corners) {
        print "f " corners
    }

    # The eight corners are numbered in binary, from 1: x counts 1, y 2, z 4.
    function cube(    i) {
        print "# A cube with corners at 1 and -1: 8 vertices, 12 triangles."
        for (i = 0; i < 8; ++i)
            vertex(i % 2 * 2 - 1, int(i / 2) % 2 * 2 - 1, int(i / 4) * 2 - 1)
        face("5 6 8"); face("5 8 7")  # front, z = 1
        face("2 1 3"); face("2 3 4")  # back
        face("6 2 4"); face("6 4 8")  # right, x = 1
        face("1 5 7"); face("1 7 3")  # left
        face("7 8 4"); face("7 4 3")  # top, y = 1
        face("1 2 6"); face("1 6 5")  # bottom
    }

    function tetrahedron() {
        print "# A regular tetrahedron in the cube of corners 1 and -1: 4 vertices, 4 triangles."
        vertex(1, 1, 1); vertex(-1, 1, -1); vertex(-1, -1, 1); vertex(1, -1, -1)
        face("1 2 3"); face("1 4 2"); face("1 3 4"); face("2 4 3")
    }

    # The vertex of a ring and a side; both start over at the end.
    function on_torus(ring, side) {
        return ring % rings * sides + side % sides + 1
    }

    # Rings stand around the y axis; the sides of a ring go around its tube.
    function torus(    ring, side, around, along, distance, turn) {
        turn = 8 * atan2(1, 1)
        printf "# A torus around the y axis, radii 1 and 0.4: %d vertices, %d quads.\n",
            rings * sides, rings * sides
        for (ring = 0; ring < rings; ++ring)
            for (side = 0; side < sides; ++side) {
                around = turn * ring / rings
                along = turn * side / sides
                distance = 1 + 0.4 * cos(along)
                vertex(distance * cos(around), 0.4 * sin(along), distance * sin(around))
            }
        for (ring = 0; ring < rings; ++ring)
            for (side = 0; side < sides; ++side)
                face(sprintf("%d %d %d %d", on_torus(ring, side), on_torus(ring, side + 1),
                    on_torus(ring + 1, side + 1), on_torus(ring + 1, side)))
    }

    # What a feature adds to the radius of a head: height in its middle, less and less around it.
    function feature(across, up, width, height_of_it, height) {
        return height * exp(-(across / width) ^ 2 - (up / height_of_it) ^ 2)
    }

    # How far the surface lies from the middle of the head; angles to the side from the nose, and upward. The
    # mouth is a cavity between two lips.
    function radius_of_head(aside, up,    side) {
        side = aside < 0 ? -aside : aside
        return 1 + feature(aside, up - 0.02, 0.16, 0.24, 0.3) \
            + feature(side - 0.38, up - 0.28, 0.17, 0.13, -0.14) \
            + feature(aside, up - 0.45, 0.5, 0.1, 0.05) \
            + feature(aside, up + 0.36, 0.3, 0.07, 0.16) \
            + feature(aside, up + 0.58, 0.26, 0.08, 0.14) \
            + feature(aside, up + 0.47, 0.24, 0.06, -0.5) \
            + feature(aside, up + 0.85, 0.35, 0.16, 0.12) \
            + feature(side - 1.55, up - 0.05, 0.1, 0.22, 0.22)
    }

    # The vertex of a ring below the crown and a side; the first and the last one are crown and chin.
    function on_head(ring, side) {
        return ring == 0 ? 1 : ring == rings ? (rings - 1) * sides + 2 : (ring - 1) * sides + side % sides + 2
    }

    # Rings lie around the y axis, from the crown down; the nose points along z.
    function head(    ring, side, pi, up, aside, radius) {
        pi = 4 * atan2(1, 1)
        printf "# A head with a mouth behind its lips: %d vertices, %d triangles.\n",
            (rings - 1) * sides + 2, 2 * (rings - 1) * sides
        for (ring = 0; ring <= rings; ++ring)
            for (side = 0; side < (ring == 0 || ring == rings ? 1 : sides); ++side) {
                up = pi / 2 - pi * ring / rings
                aside = 2 * pi * side / sides
                if (aside > pi)
                    aside -= 2 * pi
                radius = radius_of_head(aside, up)
                vertex(0.78 * radius * cos(up) * sin(aside), 1.05 * radius * sin(up),
                    0.9 * radius * cos(up) * cos(aside))
            }
        for (ring = 0; ring < rings; ++ring)
            for (side = 0; side < sides; ++side) {
                if (ring < rings - 1)
                    face(on_head(ring, side) " " on_head(ring + 1, side) " " on_head(ring + 1, side + 1))
                if (ring > 0)
                    face(on_head(ring, side) " " on_head(ring + 1, side + 1) " " on_head(ring, side + 1))
            }
    }

    # A new vertex on the sphere of radius 1, in the direction of (x, y, z).
    function on_sphere(x, y, z,    norm) {
        norm = sqrt(x * x + y * y + z * z)
        ++vertices
        X[vertices] = x / norm; Y[vertices] = y / norm; Z[vertices] = z / norm
        return vertices
    }

    # The vertex over the middle of an edge, which two triangles share.
    function middle(a, b,    edge) {
        edge = a < b ? a " " b : b " " a
        if (!(edge in middles))
            middles[edge] = on_sphere(X[a] + X[b], Y[a] + Y[b], Z[a] + Z[b])
        return middles[edge]
    }

    # A triangle becomes four, so many times over.
    function subdivided(a, b, c, times,    ab, bc, ca) {
        if (times == 0) {
            triangles[++count] = sprintf("%d %d %d", a, b, c)
            return
        }
        ab = middle(a, b); bc = middle(b, c); ca = middle(c, a)
        subdivided(a, ab, ca, times - 1)
        subdivided(ab, b, bc, times - 1)
        subdivided(ca, bc, c, times - 1)
        subdivided(ab, bc, ca, times - 1)
    }

    # The twelve vertices of an icosahedron are the corners of three golden rectangles.
    function icosphere(    golden, list, corners, i) {
        golden = (1 + sqrt(5)) / 2
        on_sphere(-1, golden, 0); on_sphere(1, golden, 0)
        on_sphere(-1, -golden, 0); on_sphere(1, -golden, 0)
        on_sphere(0, -1, golden); on_sphere(0, 1, golden)
        on_sphere(0, -1, -golden); on_sphere(0, 1, -golden)
        on_sphere(golden, 0, -1); on_sphere(golden, 0, 1)
        on_sphere(-golden, 0, -1); on_sphere(-golden, 0, 1)
        split("1 12 6  1 6 2  1 2 8  1 8 11  1 11 12  2 6 10  6 12 5  12 11 3  11 8 7  8 2 9 " \
            "4 10 5  4 5 3  4 3 7  4 7 9  4 9 10  5 10 6  3 5 12  7 3 11  9 7 8  10 9 2", corners)
        for (i = 1; i <= 60; i += 3)
            subdivided(corners[i], corners[i + 1], corners[i + 2], 2)
        printf "# A sphere of radius 1, an icosahedron divided twice: %d vertices, %d triangles.\n",
            vertices, count
        for (i = 1; i <= vertices; ++i)
            vertex(X[i], Y[i], Z[i])
        for (i = 1; i <= count; ++i)
            face(triangles[i])
    }

    BEGIN {
        if (name == "cube") cube()
        if (name == "tetrahedron") tetrahedron()
        if (name == "torus") torus()
        if (name == "head") head()
        if (name == "icosphere") icosphere()
    }'
}

# A number from 3 to 10000.
is_count() {
    case $1 in
    '' | *[!0-9]* | ??????*) return 1 ;;
    esac
    [ "$1" -ge 3 ] && [ "$1" -le 10000 ]
}

case $#,${1:-} in
1,torus) model torus 24 12; exit ;;
1,head) model head 120 160; exit ;;
3,torus | 3,head)
    is_count "$2" || usage
    is_count "$3" || usage
    model "$1" "$2" "$3"
    exit
    ;;
1,-* | 1,) usage ;;
0, | 1,*) ;;
*) usage ;;
esac

folder=${1:-$(dirname "$0")/../examples/models}
mkdir -p "$folder"
model cube >"$folder/cube.obj"
model tetrahedron >"$folder/tetrahedron.obj"
model torus 24 12 >"$folder/torus.obj"
model icosphere >"$folder/icosphere.obj"
# The scenes of t3-light have their own: an OBJ file lies in the folder of its scene.
[ $# -gt 0 ] || cp "$folder/icosphere.obj" "$folder/../t3-light/icosphere.obj"
