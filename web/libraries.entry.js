// What libraries.js offers the page, as the members of one global object, Libraries.
export {
    BackSide, BufferAttribute, BufferGeometry, DataTexture, DirectionalLight, FrontSide, Group, HemisphereLight,
    LinearFilter, LineBasicMaterial, LineSegments, Matrix4, Mesh, MeshBasicMaterial, MeshLambertMaterial,
    PerspectiveCamera, Plane, Raycaster, Scene, SphereGeometry, Spherical, SRGBColorSpace, Vector2, Vector3,
    WebGLRenderer,
} from "three";
export { OrbitControls } from "three/addons/controls/OrbitControls.js";
export { barX, dot, line, plot, pointer, rectY, ruleX, ruleY, text, tip } from "@observablehq/plot";
