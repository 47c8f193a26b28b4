import { MeshoptDecoder } from 'meshoptimizer';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';
import { STLLoader } from 'three/addons/loaders/STLLoader.js';
import { USDLoader } from 'three/addons/loaders/USDLoader.js';
import { extensionOf } from '../../src/formats/files/fileSource.ts';

type Loader = (bytes: ArrayBuffer) => unknown;

const usd: Loader = (bytes) => new USDLoader().parse(bytes);
/** three.js loaders by extension. */
const loaders: Readonly<Record<string, Loader>> = {
  usda: usd,
  usdc: usd,
  usdz: usd,
  glb: (bytes) => new GLTFLoader().setMeshoptDecoder(MeshoptDecoder).parseAsync(bytes, ''),
  obj: (bytes) => new OBJLoader().parse(new TextDecoder().decode(bytes)),
  ply: (bytes) => new PLYLoader().parse(bytes),
  stl: (bytes) => new STLLoader().parse(bytes),
};

export const threeLoader = (path: string): Loader => loaders[extensionOf(path)];
