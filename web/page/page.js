// The page: chooses a motion, advances it in real time or slower, and draws it.
import { AmbientLight, Box3, DirectionalLight, Group, HemisphereLight, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { FIDELITIES, SCALARS, SCENES, check, load } from "./engine.js";
import * as looks from "./looks.js";

const element = (id) => document.getElementById(id);
const short = (x) => (x === 0 ? "0" : Math.abs(x) >= 1e-3 && Math.abs(x) < 1e4 ? String(Number(x.toPrecision(3))) : x.toExponential(1));
// Most of a picture's time that steps may take. Units: ms.
const PATIENCE = 12;
const CRANK_RADIUS = 0.04;

const fetched = async (name) => (await fetch(name)).arrayBuffer();
const [engine, surface] = await Promise.all([fetched("engine.wasm").then(load), fetched("rod.glb").then(looks.surface)]);

const state = { scene: 0, modes: 8, fidelity: 0, scalar: 0, playing: true, time: 0, left: 0, before: 0, cost: 0, drift: [], bodies: [], own: undefined };
const trouble = (text) => { element("trouble").textContent = text; };

// Choices.
function options(id, names, chosen) {
  element(id).replaceChildren(...names.map(([value, text]) => Object.assign(document.createElement("option"), { value, text, selected: value === chosen })));
}
function choices() {
  const most = state.scene === 2 ? state.own.modes : Infinity;
  const modes = SCENES[state.scene].modes.filter((count) => count <= most);
  if (!modes.includes(state.modes)) state.modes = modes.at(-1);
  options("scene", SCENES.map(({ name }, scene) => [scene, name]).filter(([scene]) => scene < 2 || state.own), state.scene);
  options("modes", modes.map((count) => [count, count]), state.modes);
  options("fidelity", FIDELITIES.map((name, k) => [k, name]), state.fidelity);
  options("scalar", SCALARS.map((name, k) => [k, name]), state.scalar);
}
for (const id of ["scene", "modes", "fidelity", "scalar"]) {
  element(id).onchange = (event) => { state[id] = Number(event.target.value); begin(id === "scene"); };
}

// The view.
const view = element("view");
const renderer = new WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
view.append(renderer.domElement);
const scene = new Scene();
const sun = new DirectionalLight(0xffffff, 1.7);
const world = new Group();
scene.add(world, new HemisphereLight(0xffffff, 0x8d98a6, 1.6), new AmbientLight(0xffffff, 0.5), sun, sun.target);
const camera = new PerspectiveCamera(32, 1, 1e-3, 1e3);
const controls = new OrbitControls(camera, renderer.domElement);
function fit() {
  const { clientWidth: width, clientHeight: height } = view;
  const covered = width > 800 ? 300 : 0;
  camera.aspect = (width - covered) / height;
  camera.setViewOffset(width - covered, height, -covered, 0, width, height);
  camera.updateProjectionMatrix();
  renderer.setPixelRatio(window.devicePixelRatio);
  renderer.setSize(width, height);
}
window.addEventListener("resize", fit);
function stand(low, high) {
  const centre = low.clone().add(high).multiplyScalar(0.5), size = high.distanceTo(low);
  controls.target.copy(centre);
  const from = state.scene === 1 ? new Vector3(0.25, 0.3, 1) : new Vector3(0.7, 0.5, 1);
  camera.position.copy(centre).add(from.normalize().multiplyScalar(1.9 * size));
  camera.near = size * 1e-3;
  camera.far = size * 1e3;
  sun.target.position.copy(centre);
  fit();
}

function dress() {
  world.clear();
  const part = state.scene === 2 ? (state.own.surface ? looks.rod(state.own.surface) : looks.bars(state.own.body)) : looks.rod(surface);
  const modes = state.modes;
  state.bodies = state.scene === 1
    ? [{ object: looks.crank(CRANK_RADIUS), modes: 0 }, { object: part, modes }, { object: looks.piston(), modes: 0 }]
    : [{ object: part, modes }];
  world.add(...state.bodies.map(({ object }) => object));
}

function begin(stands) {
  choices();
  trouble("");
  try {
    engine.begin(state);
  } catch (error) {
    trouble(error.message);
    state.bodies = [];
    world.clear();
    return;
  }
  if (state.scene === 2 && state.own.body.geometric_stiffness) trouble("Geometric stiffness of this body is left out here.");
  Object.assign(state, { time: 0, left: 0, cost: 0, steps: 0, spent: 0, energy: engine.energy(), drift: [] });
  dress();
  draw();
  if (stands) {
    const box = new Box3().setFromObject(world);
    if (state.scene === 1) box.union(new Box3(new Vector3(-CRANK_RADIUS, -CRANK_RADIUS, 0), new Vector3(0, CRANK_RADIUS, 0)));
    stand(box.min, box.max);
  }
}

function draw() {
  const numbers = engine.look();
  const factor = 10 ** Number(element("deformation").value);
  let place = 0;
  for (const { object, modes } of state.bodies) {
    object.position.set(numbers[place], numbers[place + 1], numbers[place + 2]);
    object.quaternion.set(numbers[place + 3], numbers[place + 4], numbers[place + 5], numbers[place + 6]);
    place += 7;
    const weights = object.morphTargetInfluences ?? [];
    weights.forEach((_, mode) => { weights[mode] = mode < modes ? factor * numbers[place + mode] : 0; });
    place += modes;
  }
}

function tell() {
  const pace = 10 ** Number(element("pace").value);
  element("pace-shown").textContent = `${short(pace)} s per second`;
  element("deformation-shown").textContent = `${short(10 ** Number(element("deformation").value))} times`;
  const step = engine.stepSize();
  const drift = engine.energy() / state.energy - 1;
  const rows = [
    ["time", `${short(state.time)} s`],
    ["step", `${short(step)} s`],
    ["time per step", state.steps ? `${short((1e3 * state.spent) / state.steps)} µs` : "-"],
    ["share of real time", state.steps ? `${short((100 * state.spent * 1e-3) / (state.steps * step))} %` : "-"],
    ["change of energy", short(drift)],
  ];
  element("numbers").replaceChildren(...rows.map((row) => {
    const line = document.createElement("tr");
    line.append(...row.map((text) => Object.assign(document.createElement("td"), { textContent: text })));
    return line;
  }));
  const canvas = element("drift"), pen = canvas.getContext("2d");
  pen.clearRect(0, 0, canvas.width, canvas.height);
  const most = state.drift.reduce((a, b) => Math.max(a, Math.abs(b)), 1e-16);
  pen.strokeStyle = "#0072b2";
  pen.lineWidth = 2;
  pen.beginPath();
  state.drift.forEach((value, k) => pen.lineTo((canvas.width * k) / 299, canvas.height * (0.5 - 0.45 * (value / most))));
  pen.stroke();
  pen.fillStyle = "#5d6570";
  pen.font = "20px sans-serif";
  pen.fillText(`± ${short(most)}`, 4, 20);
}

// Time.
element("play").onclick = () => { state.playing = !state.playing; element("play").textContent = state.playing ? "pause" : "play"; };
element("again").onclick = () => begin(false);
let before, pictures = 0;
function picture(now) {
  const passed = before === undefined ? 0 : Math.min((now - before) / 1000, 0.05);
  before = now;
  if (state.playing && state.bodies.length) {
    const step = engine.stepSize();
    state.left += (passed * 10 ** Number(element("pace").value)) / step;
    const start = performance.now();
    try {
      while (state.left >= 1) {
        const some = Math.min(Math.floor(state.left), 64);
        engine.advance(some);
        state.left -= some;
        state.time += some * step;
        state.steps += some;
        if (performance.now() - start > PATIENCE) {
          state.left = 0;
          break;
        }
      }
      state.spent += performance.now() - start;
    } catch (error) {
      trouble(`Refused at ${short(state.time)} s: ${error.message}`);
      state.playing = false;
      element("play").textContent = "play";
    }
    draw();
  }
  if (pictures++ % 6 === 0 && state.bodies.length) {
    state.drift.push(engine.energy() / state.energy - 1);
    if (state.drift.length > 300) state.drift.shift();
    tell();
  }
  if (state.scene !== 1 && state.bodies[0]) {
    // a body in flight is followed
    const { position } = state.bodies[0].object;
    world.position.copy(position).multiplyScalar(-1);
  } else {
    world.position.set(0, 0, 0);
  }
  controls.update();
  sun.position.copy(camera.position);
  renderer.render(scene, camera);
}

// A user's own body.
async function take(files) {
  trouble("");
  try {
    for (const file of files) {
      if (file.name.endsWith(".glb")) {
        const own = await looks.surface(await file.arrayBuffer());
        if (!state.own) throw new Error(`${file.name}: drop the body (*.ffrf.json) first, or together with it`);
        state.own.surface = own;
      } else {
        const text = await file.text();
        const modes = engine.read(text);
        state.own = { modes, body: JSON.parse(text), surface: undefined };
        state.modes = modes;
      }
    }
    state.scene = 2;
    begin(true);
  } catch (error) {
    trouble(error.message);
  }
}
const inOrder = (files) => [...files].sort((a, b) => a.name.endsWith(".glb") - b.name.endsWith(".glb"));
element("files").onchange = (event) => take(inOrder(event.target.files));
document.body.addEventListener("dragover", (event) => { event.preventDefault(); document.body.classList.add("over"); });
document.body.addEventListener("dragleave", () => document.body.classList.remove("over"));
document.body.addEventListener("drop", (event) => {
  event.preventDefault();
  document.body.classList.remove("over");
  take(inOrder(event.dataTransfer.files));
});

// What a test asks for: ?scene=1&modes=4&..., ?time=0.01 for a motion that has gone so far, ?check for every motion in numbers, ?own=NAME for a body beside the page.
const asked = new URLSearchParams(location.search);
for (const key of ["scene", "modes", "fidelity", "scalar"]) if (asked.has(key)) state[key] = Number(asked.get(key));
if (asked.has("own")) {
  const names = asked.get("own").split(",");
  await take(inOrder(await Promise.all(names.map(async (name) => new File([await fetched(name)], name)))));
} else {
  begin(true);
}
if (asked.has("check")) {
  element("check").textContent = JSON.stringify(check(engine, state.own ? 3 : 2, 500, state.own?.modes));
  begin(true);
}
if (asked.has("time")) {
  const steps = Math.round(Number(asked.get("time")) / engine.stepSize()), start = performance.now();
  for (let k = 1; k <= 300; k++) {
    engine.advance(Math.round((steps * k) / 300) - Math.round((steps * (k - 1)) / 300));
    state.drift.push(engine.energy() / state.energy - 1);
  }
  Object.assign(state, { steps, spent: performance.now() - start, time: steps * engine.stepSize() });
  draw();
}
renderer.setAnimationLoop(picture);
document.body.dataset.ready = "yes";
