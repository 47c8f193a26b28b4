import { Document, type Node as GltfNode, WebIO } from '@gltf-transform/core';
import { KHRLightsPunctual } from '@gltf-transform/extensions';
import { scale } from '../../../math/vec3.ts';
import { msg } from '../../../messages/message.ts';
import { poseSamples } from '../../../scene/motion/motion.ts';
import type { Light, Scene } from '../../../scene/types.ts';
import { formatSpectrum, SPECTRUM_ATTRIBUTE } from '../../attributes/spectrumAttribute.ts';
import { DiagnosticLog } from '../../diagnostics/diagnosticLog.ts';
import {
  type ExportedScene,
  type ExportMotion,
  exportObjects,
  exportPoses,
  exportRigidMotion,
  orientationYUp,
  vectorYUp,
} from '../../write/exportMotion.ts';
import { ancestors, commonAncestor } from '../../write/paths.ts';
import { skeletonsOf, type WrittenSkeleton } from '../../write/skeletons.ts';
import { KHR_MATERIALS } from '../materialExtensions.ts';
import { punctualLight } from './lights.ts';
import { AnimationWriter } from './writeAnimation.ts';
import { MeshWriter } from './writeMeshes.ts';
import { isGltfSkeleton, SkinWriter } from './writeSkins.ts';

const EXTENSIONS = [KHRLightsPunctual, ...KHR_MATERIALS];

/**
 * A scene as glTF 2.0, in metres with Y up. Rigid samples become animated translations and rotations, joints skins, other
 * deforming points morph targets; all numbers are f32. `name`: of the file, with the extension `glb` (one file) or `gltf`.
 */
export async function writeGltf(scene: Scene, name: string): Promise<ExportedScene> {
  const losses = new DiagnosticLog(name);
  const document = new GltfWriter(scene, losses).write();
  const io = new WebIO().registerExtensions(EXTENSIONS);
  if (/\.glb$/i.test(name))
    return { files: new Map([[name, await io.writeBinary(document)]]), diagnostics: losses.list() };
  const basename = name.replace(/\.[^.]*$/, '');
  const { json, resources } = await io.writeJSON(document, { basename });
  const text = new TextEncoder().encode(`${JSON.stringify(json, null, 1)}\n`);
  return { files: new Map([[name, text], ...Object.entries(resources)]), diagnostics: losses.list() };
}

class GltfWriter {
  private readonly document = new Document();
  private readonly nodes = new Map<string, GltfNode>();
  /** Paths at which a node of the same name cannot be what is placed: others are below it, or it is placed already. */
  private readonly taken: Set<string>;
  private readonly root = this.document.createScene();
  private readonly scene: Scene;
  private readonly losses: DiagnosticLog;
  private readonly meshes: MeshWriter;
  private readonly animations: AnimationWriter;
  private readonly skins: SkinWriter;

  constructor(scene: Scene, losses: DiagnosticLog) {
    this.scene = scene;
    this.losses = losses;
    const { objects, cameras, lights } = scene;
    this.taken = new Set([...objects, ...cameras, ...lights].flatMap(({ path }) => ancestors(path)));
    const buffer = this.document.createBuffer();
    this.root.setName(scene.name);
    this.document.getRoot().setDefaultScene(this.root);
    this.meshes = new MeshWriter(this.document, buffer, scene, losses);
    this.animations = new AnimationWriter(this.document, buffer, scene, losses);
    this.skins = new SkinWriter({ document: this.document, buffer, scene, losses }, this.meshes, this.animations);
  }

  write(): Document {
    const { scene, losses } = this;
    this.addHints();
    const { skeletons, others } = skeletonsOf(exportObjects(scene, losses), isGltfSkeleton);
    for (const skeleton of skeletons) this.addSkeleton(skeleton);
    for (const object of others) {
      const node = this.placed(object.path, 'Mesh', object.motion);
      const weights = this.meshes.addTo(node, object);
      if (weights) this.animations.addWeights(node, weights);
    }
    for (const { path, motion, fovY } of scene.cameras) {
      const camera = this.document.createCamera().setType('perspective').setYFov(fovY).setZNear(0.01);
      const placed = exportRigidMotion(motion, this.scene, path, this.losses);
      this.placed(path, 'Camera', placed).setCamera(camera);
    }
    for (const light of scene.lights) this.addLight(light);
    const root = this.document.getRoot();
    // A buffer without bytes is not valid.
    if (root.listAccessors().length === 0) for (const buffer of root.listBuffers()) buffer.dispose();
    return this.document;
  }

  /** As `readGltf` reads them; other programs keep what they do not know. */
  private addHints(): void {
    const { beta, openAt, ...others } = this.scene.hints;
    const hints = {
      ...others,
      ...(beta && { beta: vectorYUp(this.scene, beta) }),
      ...(openAt !== undefined && { openAt: openAt + this.animations.shift }),
    };
    if (Object.keys(hints).length > 0) this.document.getRoot().getDefaultScene()?.setExtras({ slowlight: hints });
  }

  private addLight(light: Light): void {
    const punctual = punctualLight(light);
    if (!punctual) {
      this.losses.add('warning', 'convert.light', light.path, msg`glTF has no light from a sky; it is left out`);
      return;
    }
    const { type, intensity, cone, lost } = punctual;
    const motion = exportRigidMotion(punctual.motion, this.scene, light.path, this.losses);
    const most = Math.max(...intensity);
    const color = most > 0 ? scale(intensity, 1 / most) : intensity;
    const made = this.document.createExtension(KHRLightsPunctual).createLight();
    made
      .setType(type)
      .setColor([...color])
      .setIntensity(most);
    if (cone) made.setInnerConeAngle(cone.inner).setOuterConeAngle(cone.outer);
    const spectrum = punctual.spectrum && formatSpectrum(punctual.spectrum);
    if (spectrum) made.setExtras({ [SPECTRUM_ATTRIBUTE]: spectrum });
    else if (punctual.spectrum) this.losses.add('warning', 'convert.light', light.path, NO_TABLES);
    this.placed(light.path, 'Light', motion).setExtension('KHR_lights_punctual', made);
    if (lost === undefined) return;
    const message = msg`its ${lost} is lost: lights of glTF are points${cone ? msg` with a cone` : ''}`;
    this.losses.add('info', 'convert.light', light.path, message);
  }

  /** Joints are below what all their meshes are below. */
  private addSkeleton(skeleton: WrittenSkeleton): void {
    const meshNode = (path: string): GltfNode => this.nodeAt(path, 'Mesh');
    if (this.skins.writeCarried(skeleton, meshNode)) return;
    const root = this.document.createNode('Skeleton');
    const above = commonAncestor(skeleton.skins.map(({ object }) => object.path));
    if (above) this.group(above).addChild(root);
    else this.root.addChild(root);
    this.skins.write(skeleton, root, meshNode);
  }

  /** A node of its own for the thing at a path. */
  private nodeAt(path: string, kind: string): GltfNode {
    const group = this.group(path);
    const node = this.taken.has(path) ? this.document.createNode(kind) : group;
    this.taken.add(path);
    if (node !== group) group.addChild(node);
    return node;
  }

  /** At its place in the world at each time: the nodes above it only name it. */
  private placed(path: string, kind: string, motion: ExportMotion): GltfNode {
    const node = this.nodeAt(path, kind);
    const [first] = exportPoses(motion);
    node
      .setTranslation([...vectorYUp(this.scene, first.position)])
      .setRotation([...orientationYUp(this.scene, first.orientation)]);
    const samples = poseSamples(motion);
    if (samples) this.animations.addPoses(node, samples);
    return node;
  }

  private group(path: string): GltfNode {
    const known = this.nodes.get(path);
    if (known) return known;
    const end = path.lastIndexOf('/');
    const node = this.document.createNode(path.slice(end + 1));
    this.nodes.set(path, node);
    if (end > 0) this.group(path.slice(0, end)).addChild(node);
    else this.root.addChild(node);
    return node;
  }
}

/** Said of a spectrum that has no name. */
const NO_TABLES = msg`its spectrum is lost: a table of it is written beside USD alone`;
