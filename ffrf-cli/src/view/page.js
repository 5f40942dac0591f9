// Draws the model of this page: modes of a body at rest, or the motion of bodies. THREE: the library, beside this script.
"use strict";
const bytes = Uint8Array.from(atob(document.getElementById("model").textContent), (c) => c.charCodeAt(0));
new THREE.GLTFLoader().parse(bytes.buffer, "", start, (error) => say(`The model cannot be read: ${error.message}`));

function say(text) {
  document.getElementById("panel").append(make("p", { class: "hint" }, text));
}

function make(name, attributes = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (typeof value === "function") element[key] = value;
    else if (value !== false) element.setAttribute(key, value === true ? "" : value);
  }
  element.append(...children);
  return element;
}

const short = (number) => (number === 0 ? "0" : Math.abs(number) >= 1e-3 && Math.abs(number) < 1e4 ? String(Number(number.toPrecision(3))) : number.toExponential(1));

// Viridis, by five of its colours.
const COLOURS = [0x440154, 0x3b528b, 0x21918c, 0x5ec962, 0xfde725].map((hex) => new THREE.Color(hex));
function colour(share) {
  const place = Math.min(Math.max(share, 0), 1) * (COLOURS.length - 1);
  const below = Math.min(Math.floor(place), COLOURS.length - 2);
  return COLOURS[below].clone().lerp(COLOURS[below + 1], place - below);
}

function start(gltf) {
  const { title = "", pace = 1, deformation = 1 } = gltf.userData;
  const bodies = [];
  gltf.scene.traverse((mesh) => { if (mesh.isMesh) bodies.push(mesh); });
  const clip = gltf.animations[0];
  // A motion samples its own tracks: deformation can then be drawn larger than it is.
  const tracks = clip ? clip.tracks.map((track) => {
    const [name, property] = track.name.split(/\.(?=[^.]+$)/);
    const body = gltf.scene.getObjectByProperty("uuid", name) ?? gltf.scene.getObjectByName(name);
    return { body, property, sample: track.createInterpolant() };
  }) : [];

  const scene = new THREE.Scene();
  scene.add(gltf.scene, new THREE.HemisphereLight(0xffffff, 0x99a3b0, 2.2));
  const sun = new THREE.DirectionalLight(0xffffff, 1.8);
  scene.add(sun);

  // How large everything is, over the whole motion; points of a body lie within its box of rest.
  const whole = new THREE.Box3();
  const place = (time) => {
    for (const { body, property, sample } of tracks) {
      const value = sample.evaluate(time);
      if (property === "position") body.position.fromArray(value);
      else if (property === "quaternion") body.quaternion.fromArray(value).normalize();
      else for (let k = 0; k < body.morphTargetInfluences.length; k++) body.morphTargetInfluences[k] = value[k] * state.factor;
    }
  };
  const state = { factor: 1, mode: 0, amplitude: 0.06, time: 0, speed: 1, playing: true };
  for (const mesh of bodies) mesh.geometry.computeBoundingBox();
  for (let frame = 0; frame <= (clip ? 100 : 0); frame++) {
    if (clip) place((clip.duration * frame) / 100);
    gltf.scene.updateMatrixWorld(true);
    for (const mesh of bodies) whole.union(atRest(mesh).applyMatrix4(mesh.matrixWorld));
  }
  const size = Math.max(whole.getSize(new THREE.Vector3()).length(), 1e-9);
  const centre = whole.getCenter(new THREE.Vector3());

  // Markers: small spheres with names, moved by the modes of their body.
  const markers = [];
  const spokes = [];
  const corner = new THREE.Vector3();
  for (const mesh of bodies) {
    const list = mesh.userData.markers ?? [];
    const own = atRest(mesh).getSize(new THREE.Vector3()).length();
    const ball = new THREE.SphereGeometry(0.012 * own, 16, 12);
    const frame = new THREE.AxesHelper(0.16 * own);
    frame.material.depthTest = false;
    mesh.add(frame);
    markers.push({ object: frame, frame: true });
    for (const { name, position, modes, held } of list) {
      const group = new THREE.Group();
      const dot = new THREE.Mesh(ball, new THREE.MeshBasicMaterial({ color: 0xd55e00, depthTest: false, transparent: true, opacity: 0.85 }));
      dot.renderOrder = 2;
      group.add(dot, new THREE.CSS2DObject(make("div", {}, make("span", { class: "label" }, name))));
      mesh.add(group);
      markers.push({ object: group, mesh, position, modes });
      // An interface: spokes from its reference point to the nodes that it holds.
      if (held?.length) {
        const ends = new THREE.BufferGeometry();
        ends.setAttribute("position", new THREE.BufferAttribute(new Float32Array(6 * held.length), 3));
        const lines = new THREE.LineSegments(ends, new THREE.LineBasicMaterial({ color: 0xd55e00, depthTest: false, transparent: true, opacity: 0.55 }));
        lines.renderOrder = 1;
        lines.frustumCulled = false;
        mesh.add(lines);
        spokes.push({ lines, mesh, held, hub: group });
        markers.push({ object: lines });
      }
    }
    mesh.frustumCulled = false;
  }

  // Undeformed outlines of a body whose modes are shown.
  const ghosts = clip ? [] : bodies.filter((mesh) => mesh.morphTargetInfluences).map((mesh) => {
    const rest = mesh.geometry.clone();
    rest.morphAttributes = {};
    const ghost = new THREE.Mesh(rest, new THREE.MeshBasicMaterial({ color: 0x445566, wireframe: true, transparent: true, opacity: 0.1 }));
    mesh.parent.add(ghost);
    return ghost;
  });

  // Modes: how far a unit of each moves the body, and the colours of its displacement.
  const modal = !clip && bodies.find((mesh) => mesh.morphTargetInfluences);
  const names = modal ? Object.keys(modal.morphTargetDictionary) : [];
  const lengths = names.map((_, mode) => {
    const moved = modal.geometry.morphAttributes.position[mode];
    return Array.from({ length: moved.count }, (_, k) => Math.hypot(moved.getX(k), moved.getY(k), moved.getZ(k)));
  });
  const largest = lengths.map((list) => list.reduce((a, b) => Math.max(a, b), 0));
  function paint() {
    const list = lengths[state.mode], most = largest[state.mode] || 1;
    const shades = new Float32Array(3 * list.length);
    list.forEach((length, k) => colour(length / most).toArray(shades, 3 * k));
    modal.geometry.setAttribute("color", new THREE.BufferAttribute(shades, 3));
    modal.material.vertexColors = true;
    modal.material.color.set(0xffffff);
    modal.material.needsUpdate = true;
  }
  const unit = () => (largest[state.mode] > 0 ? (state.amplitude * size) / largest[state.mode] : 0);

  // The panel.
  const panel = document.getElementById("panel");
  panel.append(make("h1", {}, title || document.title));
  const slider = (text, range, value, shown, change) => {
    const out = make("output", {}, shown(value));
    const input = make("input", { type: "range", min: range[0], max: range[1], step: "any", value, "aria-label": text,
      oninput: () => { change(Number(input.value)); out.textContent = shown(Number(input.value)); } });
    panel.append(make("label", {}, text, out), input);
    return { input, set: (next) => { input.value = next; out.textContent = shown(next); } };
  };
  let clock;
  if (clip) {
    clock = slider("time", [0, clip.duration], 0, (t) => `${short(t * pace)} s`, (t) => { state.time = t; });
    slider("deformation drawn", [0, 3], 0, (x) => `${short(deformation * 10 ** x)} times`, (x) => { state.factor = 10 ** x; });
    slider("speed", [-2, 1], 0, (x) => `${short(pace * 10 ** x)} s per second`, (x) => { state.speed = 10 ** x; });
  } else if (modal) {
    panel.append(make("label", { for: "mode" }, "mode"), make("select", { id: "mode", onchange: (event) => { state.mode = Number(event.target.value); paint(); legend(); } },
      ...names.map((name, mode) => make("option", { value: mode }, name))));
    slider("largest displacement drawn", [0, 0.2], state.amplitude, (x) => `${short(100 * x)} % of the size`, (x) => { state.amplitude = x; legend(); });
    panel.append(make("div", { class: "scale" }), make("div", { class: "ends" }, make("span", {}, "0"), make("span", { id: "most" })));
    paint();
  } else {
    say("A rigid body: no modes.");
  }
  function legend() {
    document.getElementById("most").textContent = `displacement; ${short(largest[state.mode])} per unit`;
  }
  if (modal) legend();
  const box = (text, checked, change) => make("label", {}, make("input", { type: "checkbox", checked, onchange: (event) => change(event.target.checked) }), text);
  const play = make("button", { onclick: () => { state.playing = !state.playing; play.textContent = state.playing ? "pause" : "play"; } }, "pause");
  panel.append(make("div", { class: "row" }, play,
    box("mesh", false, (on) => bodies.forEach((mesh) => { mesh.material.wireframe = on; })),
    box("markers", true, (on) => markers.forEach((marker) => { if (!marker.frame) marker.object.visible = on; })),
    box("frames", true, (on) => markers.forEach((marker) => { if (marker.frame) marker.object.visible = on; })),
    ...(ghosts.length ? [box("undeformed", true, (on) => ghosts.forEach((ghost) => { ghost.visible = on; }))] : [])));
  if (clip) {
    panel.append(make("div", { class: "row" }, ...bodies.map((mesh) => make("label", {},
      make("span", { class: "swatch", style: `background:#${mesh.material.color.getHexString()}` }), mesh.userData.name ?? mesh.name))));
  }
  panel.append(make("p", { class: "hint" }, "Drag turns, right drag moves, wheel zooms. Frames: x red, y green, z blue."));

  // The camera, and one picture after another.
  const view = document.getElementById("view");
  let renderer;
  try {
    renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
  } catch (error) {
    say(`This browser cannot draw it: ${error.message}`);
    return;
  }
  const labels = new THREE.CSS2DRenderer();
  view.append(renderer.domElement, labels.domElement);
  const camera = new THREE.PerspectiveCamera(32, 1, size * 1e-3, size * 100);
  camera.position.copy(centre).add(new THREE.Vector3(0.75, 0.55, 1).normalize().multiplyScalar(size * 1.75));
  const controls = new THREE.OrbitControls(camera, labels.domElement);
  controls.target.copy(centre);
  const fit = () => {
    const { clientWidth: width, clientHeight: height } = view;
    // the panel covers the left of wide windows
    const covered = width > 800 ? 290 : 0;
    camera.aspect = (width - covered) / height;
    camera.setViewOffset(width - covered, height, -covered, 0, width, height);
    camera.updateProjectionMatrix();
    renderer.setPixelRatio(window.devicePixelRatio);
    renderer.setSize(width, height);
    labels.setSize(width, height);
  };
  window.addEventListener("resize", fit);
  fit();

  let before;
  renderer.setAnimationLoop((now) => {
    const passed = before === undefined ? 0 : Math.min((now - before) / 1000, 0.1);
    before = now;
    if (state.playing) state.time += passed * state.speed;
    if (clip) {
      state.time %= clip.duration;
      if (state.playing) clock.set(state.time);
      place(state.time);
    } else if (modal) {
      const swing = unit() * Math.sin(2 * Math.PI * (0.6 * state.time + 0.25));
      modal.morphTargetInfluences.forEach((_, mode) => { modal.morphTargetInfluences[mode] = mode === state.mode ? swing : 0; });
    }
    for (const { object, mesh, position, modes } of markers) {
      if (!position) continue;
      const weights = mesh.morphTargetInfluences ?? [];
      object.position.set(...[0, 1, 2].map((axis) => position[axis] + weights.reduce((sum, weight, mode) => sum + weight * (modes[mode]?.[axis] ?? 0), 0)));
    }
    for (const { lines, mesh, held, hub } of spokes) {
      const ends = lines.geometry.getAttribute("position");
      held.forEach((point, spoke) => {
        ends.setXYZ(2 * spoke, hub.position.x, hub.position.y, hub.position.z);
        mesh.getVertexPosition(point, corner);
        ends.setXYZ(2 * spoke + 1, corner.x, corner.y, corner.z);
      });
      ends.needsUpdate = true;
    }
    controls.update();
    sun.position.copy(camera.position).add(new THREE.Vector3(0, size, 0));
    sun.target = gltf.scene;
    renderer.render(scene, camera);
    labels.render(scene, camera);
  });
}

function atRest(mesh) {
  const points = mesh.geometry.getAttribute("position");
  return new THREE.Box3().setFromBufferAttribute(points);
}
