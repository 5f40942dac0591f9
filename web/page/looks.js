// What bodies look like: surfaces with modes as morph targets, bars where there is none.
import { Box3, BoxGeometry, BufferAttribute, BufferGeometry, CylinderGeometry, DoubleSide, Group, LineBasicMaterial, LineSegments, Mesh, MeshStandardMaterial, Points, PointsMaterial, SphereGeometry } from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";

const COLOURS = { rod: 0xc4570a, crank: 0x2a6db0, piston: 0x1c8a63 };
const material = (color) => new MeshStandardMaterial({ color, metalness: 0.15, roughness: 0.55, side: DoubleSide, flatShading: true });

// The mesh in a model of `ffrf view` (glTF, binary), and how far a unit of each mode moves it.
export async function surface(bytes) {
  const gltf = await new GLTFLoader().parseAsync(bytes, "");
  let mesh;
  gltf.scene.traverse((object) => { mesh ??= object.isMesh ? object : undefined; });
  if (!mesh) throw new Error("the model has no surface");
  return mesh.geometry;
}

// The box of a part at rest: unit displacements of its modes, which the library would add, are far from what is seen.
const bounded = (geometry) => Object.assign(geometry, { boundingBox: new Box3().setFromBufferAttribute(geometry.getAttribute("position")) });

export function rod(geometry) {
  const mesh = new Mesh(bounded(geometry), material(COLOURS.rod));
  mesh.frustumCulled = false;
  mesh.updateMorphTargets();
  return mesh;
}

export function crank(radius) {
  const group = new Group();
  const arm = new Mesh(new BoxGeometry(radius, 0.05, 0.016), material(COLOURS.crank));
  arm.position.set(radius / 2, 0, -0.022);
  const disc = new Mesh(new CylinderGeometry(0.03, 0.03, 0.016, 48), material(COLOURS.crank));
  disc.rotation.x = Math.PI / 2;
  disc.position.z = -0.022;
  const pin = new Mesh(new CylinderGeometry(0.022, 0.022, 0.05, 48), material(COLOURS.crank));
  pin.rotation.x = Math.PI / 2;
  pin.position.x = radius;
  group.add(arm, disc, pin);
  return group;
}

export function piston() {
  const group = new Group();
  const body = new Mesh(new CylinderGeometry(0.03, 0.03, 0.05, 48), material(COLOURS.piston));
  body.rotation.z = Math.PI / 2;
  body.position.x = 0.02;
  body.material.transparent = true;
  body.material.opacity = 0.55;
  group.add(body, new Mesh(new SphereGeometry(0.007, 24, 16), material(COLOURS.piston)));
  return group;
}

// A body without a surface: lines from the frame origin to its markers.
export function bars(body) {
  const ends = body.markers.length ? body.markers : [{ position: [0.1, 0, 0], translation: [] }];
  const geometry = new BufferGeometry();
  const zero = [0, 0, 0];
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(ends.flatMap((marker) => [...zero, ...marker.position])), 3));
  geometry.morphTargetsRelative = true;
  geometry.morphAttributes.position = body.modes.map((_, mode) =>
    new BufferAttribute(new Float32Array(ends.flatMap((marker) => [...zero, ...(marker.translation[mode] ?? zero)])), 3));
  const lines = new LineSegments(bounded(geometry), new LineBasicMaterial({ color: COLOURS.rod }));
  const points = new Points(geometry, new PointsMaterial({ color: COLOURS.crank, size: 9, sizeAttenuation: false }));
  for (const object of [lines, points]) {
    object.frustumCulled = false;
    object.updateMorphTargets();
  }
  points.morphTargetInfluences = lines.morphTargetInfluences;
  lines.add(points);
  return lines;
}
