"""Shape of the connecting rod: where a node of the structured mesh lies. SI units (m).

Plan view: two rings (big end with bolt bosses, small end) joined by a tapered shank; the bores run along z.
The shank is an I-section. x points from the big end to the small end; the origin here is the big end's centre.
"""
import math

CENTRE_DISTANCE = 0.150
LAYERS = [-1.0, -0.36, 0.36, 1.0]  # z over half thickness; the middle layer is the web
ACROSS = [-1.0, -0.54, 0.54, 1.0]  # across the shank: flange, web, flange
LENGTHWISE = 9                     # shank elements from ring to ring
SHANK_HALF_THICKNESS = 0.0080
SHANK_HALF_WIDTH = (0.0115, 0.0085)  # towards the big end and towards the small end


class Ring:
    """A ring of elements around a bore; angles count from the direction of the shank."""

    def __init__(self, name, x, bore, outer, boss, half_thickness, half_angle, rest, facing):
        self.name, self.x, self.bore, self.outer, self.boss = name, x, bore, outer, boss
        self.half_thickness, self.half_angle, self.facing = half_thickness, half_angle, facing
        opening = 2.0 * math.pi - 2.0 * half_angle
        # the root of the shank first, then the rest of the circle
        corners = [s * half_angle for s in ACROSS] + [half_angle + opening * k / rest for k in range(1, rest)]
        self.count = len(corners)
        self.angles = halved(corners + [corners[0] + 2.0 * math.pi])[:-1]

    def plan(self, angle, level):
        """Plan-view point; level 0 is the bore, 1 the outer contour."""
        contour = self.outer + self.boss * abs(math.sin(angle)) ** 6
        radius = self.bore + level * (contour - self.bore)
        return self.x + self.facing * radius * math.cos(angle), self.facing * radius * math.sin(angle)


def halved(values):
    """The values with their midpoints in between: corner nodes at even places, midside nodes at odd ones."""
    result = []
    for left, right in zip(values, values[1:]):
        result += [left, 0.5 * (left + right)]
    return result + [values[-1]]


BIG = Ring("big", x=0.0, bore=0.0250, outer=0.0325, boss=0.0060, half_thickness=0.0110,
           half_angle=math.radians(32), rest=15, facing=1.0)
SMALL = Ring("small", x=CENTRE_DISTANCE, bore=0.0110, outer=0.0165, boss=0.0, half_thickness=0.0100,
             half_angle=math.radians(34), rest=9, facing=-1.0)


def shank(t, across):
    """Point x, y and half thickness at t from 0 (big end) to 1 (small end): root arcs blended into a straight taper."""
    x0, y0 = BIG.plan(BIG.half_angle * across, 1.0)
    x1, y1 = SMALL.plan(-SMALL.half_angle * across, 1.0)
    at_big, at_small = (1.0 - t) ** 7, t ** 7
    straight = 1.0 - at_big - at_small
    width = SHANK_HALF_WIDTH[0] + t * (SHANK_HALF_WIDTH[1] - SHANK_HALF_WIDTH[0])
    return (x0 + t * (x1 - x0), at_big * y0 + at_small * y1 + straight * across * width,
            at_big * BIG.half_thickness + at_small * SMALL.half_thickness + straight * SHANK_HALF_THICKNESS)
