import type {
  Camera,
  Material,
  Mesh,
  MRTNode,
  NodeMaterial,
  Object3D,
  RenderTarget,
  WebGPURenderer,
} from 'three/webgpu';

/** A call of three's `render`: what it would have drawn with which materials, and where to. */
interface RenderCall {
  readonly scene: Object3D;
  readonly camera: Camera;
  readonly target: RenderTarget | null;
  readonly mrt: MRTNode | null;
  readonly materials: readonly { readonly mesh: Mesh; readonly material: Material | Material[] }[];
  /** Three gives its quads this only while they are drawn. */
  readonly quad: { readonly material: NodeMaterial; readonly vertexNode: NodeMaterial['vertexNode'] } | undefined;
}

/**
 * Goes through all that draws a picture without drawing it, and then compiles its shaders, one pass after another, between the frames that are
 * drawn meanwhile. Rejects where the device is lost.
 */
export async function precompile(renderer: WebGPURenderer, draw: () => void): Promise<void> {
  for (const call of recordCalls(renderer, draw)) await compile(renderer, call);
}

function recordCalls(renderer: WebGPURenderer, draw: () => void): RenderCall[] {
  const calls: RenderCall[] = [];
  const { render } = renderer;
  renderer.render = (scene, camera) => void calls.push(recordCall(renderer, scene, camera));
  try {
    draw();
  } finally {
    renderer.render = render;
  }
  return calls;
}

function recordCall(renderer: WebGPURenderer, scene: Object3D, camera: Camera): RenderCall {
  const dressed: { mesh: Mesh; material: Material | Material[] }[] = [];
  scene.traverse((object) => {
    if (isMesh(object)) dressed.push({ mesh: object, material: object.material });
  });
  const own = isMesh(scene) ? (scene.material as NodeMaterial) : undefined;
  const quad = own && { material: own, vertexNode: own.vertexNode };
  return { scene, camera, target: renderer.getRenderTarget(), mrt: renderer.getMRT(), materials: dressed, quad };
}

const isMesh = (object: Object3D): object is Mesh => 'isMesh' in object;

/** What three needs of the call it takes at once; then frames may be drawn with other materials, into other targets. */
async function compile(
  renderer: WebGPURenderer,
  { scene, camera, target, mrt, materials, quad }: RenderCall,
): Promise<void> {
  const before = materials.map(({ mesh }) => ({ mesh, material: mesh.material }));
  for (const { mesh, material } of materials) mesh.material = material;
  if (quad) quad.material.vertexNode = quad.vertexNode;
  renderer.setRenderTarget(target);
  renderer.setMRT(mrt);
  // `compileAsync` takes the canvas's depth buffer, or that there is none, for that of every target (three 0.187).
  const { depth } = renderer;
  renderer.depth = target?.depthBuffer ?? depth;
  const compiled = renderer.compileAsync(scene, camera);
  renderer.depth = depth;
  for (const { mesh, material } of before) mesh.material = material;
  try {
    await compiled;
  } finally {
    if (quad) quad.material.vertexNode = null;
  }
}
