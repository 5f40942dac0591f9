"""The 20-node hexahedron C3D20: node order, shape functions, Jacobian determinants."""
import itertools
import math
import sys

# natural coordinates in the node order of CalculiX: corners, edges below, edges above, upright edges
NODES = [(-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1), (-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1),
         (0, -1, -1), (1, 0, -1), (0, 1, -1), (-1, 0, -1), (0, -1, 1), (1, 0, 1), (0, 1, 1), (-1, 0, 1),
         (-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]
GAUSS = [(-math.sqrt(0.6), 5.0 / 9.0), (0.0, 8.0 / 9.0), (math.sqrt(0.6), 5.0 / 9.0)]


def shape(node, xi):
    """Value and gradient of the shape function of one node at xi (serendipity, quadratic)."""
    linear = [1.0 + c * x for c, x in zip(node, xi)]
    if 0 in node:
        middle = node.index(0)
        factor = [0.5 * value for value in linear]
        slope = [0.5 * c for c in node]
        factor[middle], slope[middle] = 1.0 - xi[middle] ** 2, -2.0 * xi[middle]
        value = factor[0] * factor[1] * factor[2]
        return value, [slope[0] * factor[1] * factor[2], factor[0] * slope[1] * factor[2],
                       factor[0] * factor[1] * slope[2]]
    bracket = sum(c * x for c, x in zip(node, xi)) - 2.0
    product = linear[0] * linear[1] * linear[2] / 8.0
    others = [linear[1] * linear[2], linear[0] * linear[2], linear[0] * linear[1]]
    return product * bracket, [c * (other * bracket / 8.0 + product) for c, other in zip(node, others)]


def map_at(points, xi):
    """Position and Jacobian determinant at natural coordinates xi."""
    position, jacobian = [0.0] * 3, [[0.0] * 3 for _ in range(3)]
    for node, point in zip(NODES, points):
        value, gradient = shape(node, xi)
        for i in range(3):
            position[i] += value * point[i]
            for j in range(3):
                jacobian[i][j] += gradient[j] * point[i]
    a, b, c = jacobian
    return position, (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
                      + a[2] * (b[0] * c[1] - b[1] * c[0]))


def volume_and_centre(points, elements):
    """Volume, centroid and smallest Jacobian relative to the element's centre.

    3 x 3 x 3 Gauss points; there and at the 20 nodes every determinant must be positive.
    """
    volume, moment, smallest = 0.0, [0.0] * 3, math.inf
    for number, element in enumerate(elements):
        corners = [points[n] for n in element]
        determinants = [map_at(corners, node)[1] for node in NODES]
        for (x, u), (y, v), (z, w) in itertools.product(GAUSS, GAUSS, GAUSS):
            position, determinant = map_at(corners, (x, y, z))
            determinants.append(determinant)
            volume += u * v * w * determinant
            moment = [m + u * v * w * determinant * p for m, p in zip(moment, position)]
        if min(determinants) <= 0.0:
            sys.exit(f"element {number + 1}: Jacobian determinant {min(determinants):.3e} is not positive")
        smallest = min(smallest, min(determinants) / map_at(corners, (0.0, 0.0, 0.0))[1])
    return volume, [m / volume for m in moment], smallest
