import type { Animation, Mesh as GltfMesh, Node as GltfNode, Scene as GltfScene } from '@gltf-transform/core';
import type { Light as GltfLight } from '@gltf-transform/extensions';
import { rotate } from '../../../math/quat.ts';
import { scale, type Vec3 } from '../../../math/vec3.ts';
import { listed, type Message, msg } from '../../../messages/message.ts';
import { messageOf } from '../../../messages/messageError.ts';
import { FOREVER, makeObject, makeScene } from '../../../scene/defaults.ts';
import {
  type DistantLight,
  InputError,
  type Light,
  type RigidMotion,
  type Scene,
  type SceneCamera,
  type SceneHints,
  type SceneObject,
  type SphereLight,
} from '../../../scene/types.ts';
import { parseSceneHints } from '../../attributes/hints.ts';
import { parseSpectrum, SPECTRUM_ATTRIBUTE, unknownSpectrumMessage } from '../../attributes/spectrumAttribute.ts';
import { DiagnosticLog } from '../../diagnostics/diagnosticLog.ts';
import { type FileSource, stemOf } from '../../files/fileSource.ts';
import type { OutlinedMesh } from '../../read/jointOutline.ts';
import { MAX_OBJECTS } from '../../read/limits.ts';
import { settleStretches } from '../../read/stretches.ts';
import type { ReadOptions } from '../../readOptions.ts';
import { type GltfContext, gltfError } from '../context.ts';
import { loadGltf } from '../load/loadGltf.ts';
import { StrandPlan } from '../strands/strandPlan.ts';
import { Baker, outlined } from './bake.ts';
import { makeDeformer, settleMorphs, skeletonOf } from './deform.ts';
import { readInstances } from './instances.ts';
import { lightSpectra } from './lightSpectra.ts';
import { GltfMaterialLibrary } from './materials.ts';
import { type AnimatedTransform, type NodeTransform, NodeTree } from './nodes.ts';
import { type Geometry, readGeometry } from './primitives.ts';
import { variantSet } from './variants.ts';

/** Radius given to glTF's point lights, which have none [m]. */
export const POINT_LIGHT_RADIUS = 0.05;
/** Maximum number of vertices of a scene; shared meshes count once. */
export const MAX_VERTICES = 2 ** 26;
const TOO_MANY_OBJECTS = msg`${MAX_OBJECTS} objects with all copies of its meshes`;
const TOO_MANY_VERTICES = msg`${MAX_VERTICES} vertices with all sizes of its meshes`;

/**
 * Reads glTF 2.0 (.gltf with its files, .glb). Node, morph and skin animations become sampled motions in the world
 * frame. Throws only InputErrors; ignored features are in the scene's diagnostics.
 */
export async function readGltf(source: FileSource, entry: string, options: ReadOptions = {}): Promise<Scene> {
  try {
    const notes = new DiagnosticLog(entry);
    const file = await loadGltf(source, entry, notes, options.decodePicture);
    const variants = variantSet({ entry, json: file.json, options });
    const spectra = await lightSpectra(source, entry, file.json, notes);
    const context: GltfContext = { entry, options, notes, variants, spectra, ...file };
    return buildScene(context);
  } catch (thrown) {
    if (thrown instanceof InputError) throw thrown;
    throw gltfError(entry, 'gltf.invalid', '', msg`not a valid glTF (${messageOf(thrown)}); export it again`, thrown);
  }
}

function buildScene(context: GltfContext): Scene {
  const root = context.document.getRoot();
  const animation = chooseAnimation(context);
  const tree = new NodeTree(context, animation);
  const shown = root.getDefaultScene() ?? root.listScenes()[0];
  const times = [...(animation?.listSamplers() ?? [])].flatMap((s) => [...(s.getInput()?.getArray() ?? [])]);
  const startTime = times.reduce((a, b) => Math.min(a, b), times[0] ?? 0);
  const roots = shown?.listChildren() ?? root.listNodes().filter((n) => !n.getParentNode());
  const nodes = visibleNodes(context, tree, roots);
  const builder = new SceneBuilder(context, tree, new StrandPlan(context, tree, nodes, startTime));
  for (const node of nodes) builder.add(node);
  return makeScene({
    name: shown?.getName() || stemOf(context.entry),
    upAxis: 'Y',
    hints: hintsOf(shown),
    metersPerUnit: 1,
    startTime,
    endTime: times.reduce((a, b) => Math.max(a, b), 0),
    objects: settleStretches(builder.objects),
    materials: builder.library.materials,
    lights: builder.lights,
    cameras: builder.cameras,
    ...offered(context, animation),
    ...(builder.pathError !== undefined && { pathError: builder.pathError }),
    diagnostics: context.notes.list(),
  });
}

/** `extras.slowlight` of the scene. */
function hintsOf(shown: GltfScene | undefined): SceneHints {
  const own = shown?.getExtras().slowlight;
  const values = new Map(typeof own === 'object' && own !== null ? Object.entries(own) : []);
  return parseSceneHints((name) => values.get(name));
}

/** Animations are selected like a variant set. */
const ANIMATION_SET = 'animation';

const animationNames = ({ document }: GltfContext): string[] =>
  document
    .getRoot()
    .listAnimations()
    .map((a, i) => a.getName() || `animation ${i}`);

/** Variant sets of the file: material variants, and animations if there are several. */
function offered(context: GltfContext, shown: Animation | undefined): Pick<Scene, 'variants'> {
  const names = animationNames(context);
  const place = shown ? context.document.getRoot().listAnimations().indexOf(shown) : 0;
  const animations = { set: ANIMATION_SET, options: [...new Set(names)], chosen: names[place] ?? '' };
  const sets = [...(context.variants ? [context.variants] : []), ...(names.length > 1 ? [animations] : [])];
  return sets.length > 0 ? { variants: sets } : {};
}

function chooseAnimation(context: GltfContext): Animation | undefined {
  const { document, entry, notes, options } = context;
  const all = document.getRoot().listAnimations();
  const names = animationNames(context);
  const asked = options.animation ?? options.variants?.get(ANIMATION_SET);
  const place = typeof asked === 'string' ? names.indexOf(asked) : (asked ?? 0);
  if (asked !== undefined && !all[place]) {
    const known = names.length > 0 ? msg`there are ${listed(names)}` : msg`there is none`;
    throw gltfError(entry, 'gltf.no-animation', '', msg`no animation ${asked}; ${known}`);
  }
  if (all.length > 1) {
    notes.add(
      'info',
      'gltf.animations',
      '',
      msg`${all.length} animations (${listed(names)}); ${names[place]} is shown`,
    );
  }
  return all[place];
}

/** Number of sets of joints, and of meshes that bend by themselves. */
function bendingThings({ document }: GltfContext, tree: NodeTree): number {
  const nodes = document
    .getRoot()
    .listNodes()
    .filter((node) => node.getMesh());
  const skeletons = new Set(nodes.filter((node) => node.getSkin()).map((node) => skeletonOf(tree, node)));
  return skeletons.size + nodes.filter((node) => tree.weightsCurve(node)).length;
}

/** These nodes and all below them, without those that are hidden. */
function visibleNodes(
  context: GltfContext,
  tree: NodeTree,
  from: readonly GltfNode[],
  into: GltfNode[] = [],
): GltfNode[] {
  for (const node of from) {
    const extensions = context.json.nodes?.[tree.placeOf(node)].extensions;
    const visibility = extensions?.KHR_node_visibility as { readonly visible?: unknown } | undefined;
    if (visibility?.visible === false) continue;
    into.push(node);
    visibleNodes(context, tree, node.listChildren(), into);
  }
  return into;
}

/** Collects the contents of a scene's nodes. */
class SceneBuilder {
  readonly objects: SceneObject[] = [];
  readonly lights: Light[] = [];
  readonly cameras: SceneCamera[] = [];
  readonly library: GltfMaterialLibrary;
  private readonly context: GltfContext;
  private readonly tree: NodeTree;
  private readonly baker: Baker;
  private readonly strands: StrandPlan;
  private readonly geometries = new Map<GltfMesh, Map<string, Geometry | undefined>>();
  private readonly counted = new Set<Float32Array>();
  private vertices = 0;
  constructor(context: GltfContext, tree: NodeTree, strands: StrandPlan) {
    this.context = context;
    this.strands = strands;
    this.tree = tree;
    this.baker = new Baker(context, bendingThings(context, tree));
    this.library = new GltfMaterialLibrary(context);
  }

  get pathError(): number | undefined {
    return this.baker.pathError;
  }

  add(node: GltfNode): void {
    this.addMesh(node);
    this.addCamera(node);
    this.addLight(node);
  }

  /** The node's path if it has one role and no children; else a unique path below it. */
  private pathOf(node: GltfNode, name: string): string {
    const parts = [node.getMesh(), node.getCamera(), node.getExtension('KHR_lights_punctual')];
    const isAlone = parts.filter((part) => part !== null).length === 1 && node.listChildren().length === 0;
    return isAlone ? this.tree.path(node) : this.tree.pathBelow(node, name);
  }

  private addMesh(node: GltfNode): void {
    const mesh = node.getMesh();
    if (!mesh) return;
    const geometry = this.geometryOf(node, mesh);
    if (!geometry) return;
    const instances = this.instances(node, geometry);
    if (!instances) this.addObject(node, geometry, this.tree.frame(node), this.pathOf(node, 'Mesh'));
    for (const [i, within] of (instances ?? []).entries()) {
      const path = this.tree.pathBelow(node, `Instance${i}`);
      this.addObject(node, geometry, this.tree.frame(node, within), path);
    }
  }

  /** The mesh of a node, with its morph targets settled where nothing moves them. */
  private geometryOf(node: GltfNode, mesh: GltfMesh): Geometry | undefined {
    const strands = this.strands.frameOf(node, mesh);
    const known = this.geometries.get(mesh) ?? new Map<string, Geometry | undefined>();
    this.geometries.set(mesh, known);
    const key = strands?.key ?? '';
    if (!known.has(key)) known.set(key, readGeometry(this.context, mesh, this.library, strands));
    const shared = known.get(key);
    return shared && !this.tree.weightsCurve(node) ? settleMorphs(node, shared) : shared;
  }

  /** All meshes that nothing but these joints moves. */
  private peersOf(skeleton: string | undefined): OutlinedMesh[] {
    const nodes = this.context.document.getRoot().listNodes();
    return nodes.flatMap((node) => {
      const mesh = node.getSkin() && skeletonOf(this.tree, node) === skeleton ? node.getMesh() : null;
      const geometry = mesh && this.geometryOf(node, mesh);
      if (!geometry?.skin) return [];
      const deformer = makeDeformer(this.context, this.tree, node, this.tree.frame(node), geometry);
      return deformer.skeleton === skeleton ? [outlined(geometry, deformer)] : [];
    });
  }

  private instances(node: GltfNode, { skin }: Geometry): NodeTransform[] | undefined {
    const what = this.tree.path(node);
    const instances = readInstances(this.context, node, what);
    if (!instances || !skin || !node.getSkin()) return instances;
    const message = msg`its instances all follow the same joints, so that they are in one place; one is shown`;
    this.context.notes.add('warning', 'gltf.instances', what, message);
    return undefined;
  }

  private addObject(node: GltfNode, geometry: Geometry, frame: AnimatedTransform, path: string): void {
    this.bound(frame, this.objects.length < MAX_OBJECTS, TOO_MANY_OBJECTS);
    const deformer = makeDeformer(this.context, this.tree, node, frame, geometry);
    const bends = geometry.morphs.length > 0 || (geometry.skin && node.getSkin());
    const baked = bends
      ? this.baker.bakePoints(frame, geometry, deformer, () => this.peersOf(deformer.skeleton))
      : this.baker.bakeAffine(frame, geometry, deformer);
    const { positions } = baked.mesh;
    if (!this.counted.has(positions)) this.vertices += positions.length / 3;
    this.counted.add(positions);
    this.bound(frame, this.vertices <= MAX_VERTICES, TOO_MANY_VERTICES);
    this.objects.push(makeObject({ path, ...baked }));
  }

  private bound({ path }: AnimatedTransform, isKept: boolean, most: Message): void {
    if (!isKept) throw gltfError(this.context.entry, 'gltf.too-large', path, msg`more than ${most}; export fewer`);
  }

  private addCamera(node: GltfNode): void {
    const camera = node.getCamera();
    if (!camera) return;
    const path = this.pathOf(node, 'Camera');
    if (camera.getType() !== 'perspective') {
      this.context.notes.add('warning', 'gltf.camera', path, msg`an orthographic camera is not read; it is left out`);
      return;
    }
    const fovY = camera.getYFov();
    if (!(fovY > 0 && fovY < Math.PI)) {
      this.context.notes.add('warning', 'gltf.camera', path, msg`its field of view is ${fovY} rad; it is left out`);
      return;
    }
    this.cameras.push({ path, motion: this.baker.bakeFrame(this.tree.frame(node)), fovY });
  }

  private addLight(node: GltfNode): void {
    const light = node.getExtension<GltfLight>('KHR_lights_punctual');
    if (!light) return;
    const path = this.pathOf(node, 'Light');
    const color = scale(light.getColor(), light.getIntensity());
    const range = light.getRange();
    if (range)
      this.context.notes.add(
        'info',
        'gltf.light',
        path,
        msg`its range of ${range} m is left out: light goes on for ever`,
      );
    if (light.getType() === 'directional') {
      this.lights.push({
        kind: 'distant',
        path,
        direction: this.shining(node, path),
        color,
        ...this.spectrum(light, path),
      });
      return;
    }
    const motion = this.baker.bakeFrame(this.tree.frame(node));
    const local = { ...pointLight(path, motion, color), ...this.spectrum(light, path) };
    const shaping = { inner: light.getInnerConeAngle(), outer: light.getOuterConeAngle(), focus: 0 };
    this.lights.push(light.getType() === 'spot' ? { ...local, shaping } : local);
  }

  /** Spectrum of a light from its extras. */
  private spectrum(light: GltfLight, path: string): Pick<DistantLight, 'spectrum'> {
    const written = new Map(Object.entries(light.getExtras())).get(SPECTRUM_ATTRIBUTE);
    if (written === undefined) return {};
    const { notes, spectra } = this.context;
    const name = String(written);
    const spectrum = spectra.get(name) ?? (typeof written === 'string' ? parseSpectrum(written) : undefined);
    if (spectrum) return { spectrum };
    // Missing files have been reported already.
    if (!spectra.has(name)) notes.add('warning', 'gltf.slowlight', path, unknownSpectrumMessage(name));
    return {};
  }

  /** Direction of a distant light at the start. */
  private shining(node: GltfNode, path: string): Vec3 {
    const curves = this.tree.curvesAbove(node);
    if (curves.length > 0)
      this.context.notes.add('warning', 'gltf.light', path, msg`a turning sun is held where it starts`);
    const start = curves.length > 0 ? Math.min(...curves.map((curve) => curve.times[0])) : 0;
    return rotate(this.tree.transformAt(node, start).rotation, [0, 0, -1]);
  }
}

/** A small sphere of radiance L has the luminous intensity I = π r² L of the point [cd]. */
function pointLight(path: string, motion: RigidMotion, intensity: Vec3): SphereLight {
  const radius = POINT_LIGHT_RADIUS;
  return {
    kind: 'sphere',
    path,
    motion,
    lifetime: FOREVER,
    radius,
    color: scale(intensity, 1 / (Math.PI * radius * radius)),
  };
}
