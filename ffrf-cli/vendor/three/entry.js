export {
  AmbientLight, AxesHelper, Box3, BufferAttribute, Color, DirectionalLight, DoubleSide, Group, HemisphereLight, Mesh,
  MeshBasicMaterial, MeshStandardMaterial, PerspectiveCamera, Scene, SphereGeometry, Vector3, WebGLRenderer,
} from "three";
export { OrbitControls } from "three/addons/controls/OrbitControls.js";
export { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
export { CSS2DObject, CSS2DRenderer } from "three/addons/renderers/CSS2DRenderer.js";
