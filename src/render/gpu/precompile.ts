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

/** A recorded call of three's `render`: what it would have drawn, with which materials, and where to. */
interface RenderCall {
  readonly scene: Object3D;
  readonly camera: Camera;
  readonly target: RenderTarget | null;
  readonly mrt: MRTNode | null;
  readonly materials: readonly { readonly mesh: Mesh; readonly material: Material | Material[] }[];
  /** Three.js sets a quad's vertex node only while the quad is drawn. */
  readonly quad: { readonly material: NodeMaterial; readonly vertexNode: NodeMaterial['vertexNode'] } | undefined;
}

/** What each renderer of three.js compiles last. */
const queues = new WeakMap<WebGPURenderer, Promise<void>>();

/**
 * Records everything that draws a picture without drawing it, and then compiles its shaders asynchronously, one pass after another, while frames are drawn in
 * between, and after what is being compiled already. What is left when `signal` is aborted is not compiled. Rejects if the device is lost.
 */
export function precompile(renderer: WebGPURenderer, draw: () => void, signal?: AbortSignal): Promise<void> {
  const calls = recordCalls(renderer, draw);
  const compileAll = async (): Promise<void> => {
    for (const call of calls) if (!signal?.aborted) await compile(renderer, call);
  };
  const compiled = (queues.get(renderer) ?? Promise.resolve()).then(compileAll, compileAll);
  queues.set(renderer, compiled);
  return compiled;
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
  const materials: { mesh: Mesh; material: Material | Material[] }[] = [];
  scene.traverse((object) => {
    if (isMesh(object)) materials.push({ mesh: object, material: object.material });
  });
  const quadMaterial = isMesh(scene) ? (scene.material as NodeMaterial) : undefined;
  const quad = quadMaterial && { material: quadMaterial, vertexNode: quadMaterial.vertexNode };
  return { scene, camera, target: renderer.getRenderTarget(), mrt: renderer.getMRT(), materials, quad };
}

const isMesh = (object: Object3D): object is Mesh => 'isMesh' in object;

/**
 * Three.js reads all it needs of the call synchronously; afterwards frames may be drawn with other materials and into other targets. Of materials that only
 * hidden meshes have, one mesh is shown to it: they may be in view when the picture is drawn.
 */
async function compile(
  renderer: WebGPURenderer,
  { scene, camera, target, mrt, materials, quad }: RenderCall,
): Promise<void> {
  const previous = materials.map(({ mesh }) => ({ mesh, material: mesh.material, visible: mesh.visible }));
  const seen = new Set(materials.flatMap(({ mesh, material }) => (mesh.visible ? [material] : [])));
  for (const { mesh, material } of materials) {
    mesh.material = material;
    mesh.visible ||= !seen.has(material);
    seen.add(material);
  }
  if (quad) quad.material.vertexNode = quad.vertexNode;
  renderer.setRenderTarget(target);
  renderer.setMRT(mrt);
  // For every target, `compileAsync` assumes the canvas's setting for the depth buffer (three 0.187).
  const { depth } = renderer;
  renderer.depth = target?.depthBuffer ?? depth;
  const compiled = renderer.compileAsync(scene, camera);
  renderer.depth = depth;
  for (const { mesh, material, visible } of previous) Object.assign(mesh, { material, visible });
  const disposal = whenDisposed(materials.flatMap(({ material }) => material));
  try {
    await Promise.race([compiled, disposal.happened]);
  } finally {
    disposal.forget();
    if (quad) quad.material.vertexNode = null;
  }
}

/** When any of these is disposed, as with its scene; geometries come and go while a picture moves. With it three.js deletes the shader that it polls, and would wait for it forever (0.187, WebGL). */
function whenDisposed(parts: readonly Material[]): { happened: Promise<void>; forget(): void } {
  let tell = (): void => {};
  const happened = new Promise<void>((resolve) => {
    tell = resolve;
  });
  for (const part of parts) part.addEventListener('dispose', tell);
  return {
    happened,
    forget: () => {
      for (const part of parts) part.removeEventListener('dispose', tell);
    },
  };
}
