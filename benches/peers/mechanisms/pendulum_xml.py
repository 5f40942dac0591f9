#!/usr/bin/env python3
"""Writes the rigid pendulum of pendulum.h for MuJoCo. usage: pendulum_xml.py OUT N [N ...] -> OUT/pendulum_N.xml"""
import sys

HEAD = """<mujoco><compiler angle="radian" inertiafromgeom="false"/><option gravity="0 -9.81 0">
<flag contact="disable" constraint="disable"/></option><worldbody>
"""
for n in map(int, sys.argv[2:]):
    links = "".join(
        f'<body pos="{0.3 if k else 0} 0 0"><joint type="hinge" axis="0 0 1"/>'
        '<inertial pos="0.15 0 0" mass="0.6" diaginertia="1e-3 5e-3 5e-3"/>\n'
        for k in range(n)
    )
    with open(f"{sys.argv[1]}/pendulum_{n}.xml", "w") as file:
        file.write(HEAD + links + "</body>" * n + "</worldbody></mujoco>\n")
