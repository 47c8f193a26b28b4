import { IDENTITY, invert } from '../../math/mat4.ts';
import type { Lifetime, Light, Scene, SceneCamera, SceneObject } from '../../scene/types.ts';
import { MAX_OBJECTS } from '../limits.ts';
import { attributeOf, sampleTimes, type TimeCode, textAt } from './attributes.ts';
import { cameraOf } from './cameras.ts';
import { parentOf } from './compose/paths.ts';
import { isActive } from './compose/stage.ts';
import { ancestorsOf, report, type StageContext } from './context.ts';
import { noteUnreadValues, unreadType } from './coverage.ts';
import { childFrame, type Frame, frameOf, nestedFrame, ROOT_FRAME } from './frame.ts';
import { implicitShape, isImplicit } from './gprims.ts';
import { addPrototypes, Instancers, type Setting } from './instancer/instancers.ts';
import type { PrimSpec } from './layer.ts';
import { isLight, isUnreadLight, lightOf } from './lights.ts';
import { MaterialTable } from './materials.ts';
import { meshShape } from './meshes.ts';
import { geometryLights, glowing, lightOn, type MeshLight } from './meshLights.ts';
import type { Part, Site, Subtree } from './parts.ts';
import { placeDrifting, placeShape, placeStill } from './placement.ts';
import type { Shape } from './shape.ts';
import { remade, SharedShapes } from './sharedShapes.ts';
import { maybeBound, Skeletons } from './skel/binding.ts';
import {
  authoredInOf,
  checkDirections,
  type Directions,
  directedMotion,
  directionsOf,
  lifetimeOf,
  poseTimeOf,
} from './slowlight.ts';
import { type Binding, bindingOf, type Surface, surfaceOf } from './surface.ts';
import { TextureLoader } from './textures.ts';
import { MAX_OPS, transformOf } from './xformOps.ts';

/** What a prim hands down to its children. */
interface Inherited {
  readonly frame: Frame;
  readonly binding: Binding | undefined;
  readonly directions: Directions;
  /** A skeleton may bend it. */
  readonly maybeBound: boolean;
  /** Of the nearest prim above that says what it is for. */
  readonly purpose: string;
  /** Where what is found goes: into the scene, or into a prototype of instances. */
  readonly found: Found;
}

interface Found {
  /** Of the scene itself, whose lights and cameras count. */
  readonly isScene: boolean;
  part(part: Part): void;
  instancer(site: Site): Promise<void>;
}

const AT_ROOT = { frame: ROOT_FRAME, binding: undefined, directions: {}, maybeBound: false, purpose: 'default' };

export type StageContents = Pick<Scene, 'objects' | 'materials' | 'lights' | 'cameras'>;

/** Turns the defined, active, visible prims of a stage into what is observed. */
export async function readStage(context: StageContext): Promise<StageContents> {
  const reader = new StageReader(context);
  for (const prim of context.layer.rootPrims.values()) await reader.visit(prim, { ...AT_ROOT, found: reader.scene });
  return { objects: reader.objects, materials: reader.table.materials, lights: reader.lights, cameras: reader.cameras };
}

class StageReader {
  readonly objects: SceneObject[] = [];
  readonly lights: Light[] = [];
  readonly cameras: SceneCamera[] = [];
  readonly table: MaterialTable;
  private readonly context: StageContext;
  readonly scene: Found;
  private readonly textures: TextureLoader;
  private readonly geometryLights: ReadonlyMap<string, PrimSpec>;
  private readonly shapes = new SharedShapes();
  /** Paths of what instancers show: what only holds it need not be defined. */
  private readonly prototypes: ReadonlySet<string>;
  private readonly skeletons: Skeletons;

  constructor(context: StageContext) {
    this.context = context;
    this.textures = new TextureLoader(context);
    this.skeletons = new Skeletons(context);
    this.table = new MaterialTable(context, this.textures);
    this.geometryLights = geometryLights(context.layer.rootPrims.values());
    this.prototypes = addPrototypes(context.layer.rootPrims, new Set());
    const instancers = new Instancers(context, {
      subtree: (prim) => this.subtree(prim),
      draw: (part, path, setting) => this.drawInstance(part, path, setting),
      room: () => MAX_OBJECTS - this.objects.length,
    });
    this.scene = {
      isScene: true,
      part: (part) => this.draw(part),
      instancer: (site) => instancers.expand(site),
    };
  }

  async visit(prim: PrimSpec, inherited: Inherited): Promise<void> {
    if (!this.isThere(prim)) return;
    await this.read(prim, this.inherit(prim, inherited));
  }

  /** A prim that is there, and all below it. */
  private async read(prim: PrimSpec, own: Inherited): Promise<void> {
    const drawn = isDrawn(own.purpose);
    if (drawn) await this.readHere(prim, own);
    // What is under an instancer is its prototypes, which are nowhere themselves.
    if (prim.typeName === 'PointInstancer') {
      if (drawn) await own.found.instancer({ prim, frame: own.frame, directions: own.directions });
      return;
    }
    for (const child of prim.children.values()) await this.visit(child, own);
  }

  /** A prototype, whether it is defined or not; materials are bound to it where it stands. */
  private async subtree(prim: PrimSpec): Promise<Subtree> {
    const parts: Part[] = [];
    const instancers: Site[] = [];
    const found: Found = {
      isScene: false,
      part: (part) => parts.push(part),
      instancer: async (site) => {
        instancers.push(site);
      },
    };
    const parentPath = parentOf(prim.path);
    const above = ancestorsOf(this.context.layer, prim.path);
    const binding = above.reduce<Binding | undefined>((around, ancestor) => bindingOf(ancestor, around), undefined);
    const bound = above.reduce((around, ancestor) => maybeBound(ancestor, around), false);
    if (isActive(prim) && this.isVisible(prim))
      await this.read(prim, this.inherit(prim, { ...AT_ROOT, binding, maybeBound: bound, found }));
    return { parentPath, parts, instancers };
  }

  private async readHere(prim: PrimSpec, own: Inherited): Promise<void> {
    noteUnreadValues(this.context, prim);
    const { typeName } = prim;
    const unread = isUnreadLight(typeName) ? `${typeName} is a light that is not read` : unreadType(typeName);
    if (unread) report(this.context, 'warning', 'usd.unsupported-prim', prim.path, unread);
    await this.readThing(prim, own);
  }

  private isThere(prim: PrimSpec): boolean {
    if (prim.specifier === 'class' || !isActive(prim)) return false;
    if (prim.specifier === 'over') {
      const message = "an 'over' changes this prim, and nothing defines it; it is left out";
      if (!this.prototypes.has(prim.path)) report(this.context, 'warning', 'usd.undefined-prim', prim.path, message);
      return false;
    }
    return this.isVisible(prim);
  }

  private isVisible(prim: PrimSpec): boolean {
    if (sampleTimes(attributeOf(prim, 'visibility')).length > 0)
      report(
        this.context,
        'warning',
        'usd.animated-visibility',
        prim.path,
        'its visibility changes with time; it is held at the start (slowlight:birth and slowlight:death can say when it exists)',
      );
    return textAt(prim, 'visibility', this.context.startCode) !== 'invisible';
  }

  private inherit(prim: PrimSpec, inherited: Inherited): Inherited {
    const transform = transformOf(prim, this.context.cubic);
    for (const name of transform.unknown)
      report(
        this.context,
        'warning',
        'usd.xform-op',
        prim.path,
        `xformOpOrder names '${name}', which is no transform of this prim; it is left out`,
      );
    if (transform.tooMany) {
      const message = `xformOpOrder names ${transform.tooMany} transforms; the first ${MAX_OPS} are used (write their product as one matrix)`;
      report(this.context, 'warning', 'usd.xform-op', prim.path, message);
    }
    const directions = directionsOf(prim, inherited.directions);
    if (directions !== inherited.directions) checkDirections(this.context, prim.path, directions);
    return {
      frame: childFrame(transform.resetsStack ? ROOT_FRAME : inherited.frame, transform.ops, holdsFrames(prim)),
      binding: bindingOf(prim, inherited.binding),
      directions,
      maybeBound: maybeBound(prim, inherited.maybeBound),
      purpose: textAt(prim, 'purpose', undefined) ?? inherited.purpose,
      found: inherited.found,
    };
  }

  private async readThing(prim: PrimSpec, own: Inherited): Promise<void> {
    const lights = isLight(prim.typeName);
    if ((lights || prim.typeName === 'Camera') && !own.found.isScene) {
      const message = `a ${prim.typeName} in a prototype of instances is not read; it is left out`;
      report(this.context, 'warning', 'usd.instancer', prim.path, message);
    } else if (prim.typeName === 'Camera') this.cameras.push(cameraOf(this.context, prim, own.frame));
    else if (lights) this.lights.push(await lightOf(this.context, this.textures, prim, own.frame, own.directions));
    else if (prim.typeName === 'Mesh' || isImplicit(prim.typeName)) await this.readPart(prim, own);
  }

  private async readPart(prim: PrimSpec, own: Inherited): Promise<void> {
    const { binding, frame, directions, found } = own;
    const surface = await surfaceOf(this.context, this.table, prim, binding);
    const make = (): Shape | undefined => this.shapeOf(prim, surface);
    // What is bent has its form from more than its own opinions.
    const shape = own.maybeBound ? make() : this.shapes.of(prim, surface, make);
    if (!shape) return;
    const place = shape.frame && !found.isScene ? this.inPrototype(prim, frame, shape.frame) : (shape.frame ?? frame);
    const light = lightOn(prim, this.geometryLights);
    const part = { path: prim.path, shape, frame: place, directions, colorable: surface.colorable };
    found.part({ ...part, ...(light && { light }) });
  }

  /** A frame of the stage, from that of a prim in it, where the prim stands in a prototype. */
  private inPrototype(prim: PrimSpec, frame: Frame, target: Frame): Frame {
    const own = frameOf(this.context.layer, prim.path);
    const back = { ...own, matrixAt: (time: TimeCode) => invert(own.matrixAt(time)) ?? IDENTITY };
    return nestedFrame(frame, nestedFrame(back, target));
  }

  private draw({ path, shape, frame, directions, light }: Part): void {
    const placed = this.placed(path, shape, frame, directions);
    this.add(path, directions, this.lit(placed, light), lifetimeOf(directions));
  }

  private drawInstance(part: Part, path: string, setting: Setting): void {
    if (this.objects.length >= MAX_OBJECTS) return;
    const frame = nestedFrame(setting.frame, part.frame);
    const placed = setting.drift
      ? placeDrifting(this.context, path, part.shape, frame, setting.drift)
      : this.placed(path, part.shape, frame, setting.directions);
    const { color } = setting;
    const mesh =
      color && part.colorable !== undefined
        ? remade(placed.mesh, part.colorable, this.table.colored(part.colorable, color))
        : placed.mesh;
    const own = lifetimeOf(setting.directions);
    const lifetime = {
      birth: Math.max(own.birth, setting.lifetime.birth),
      death: Math.min(own.death, setting.lifetime.death),
    };
    this.add(path, setting.directions, this.lit({ ...placed, mesh }, part.light), lifetime);
  }

  private lit(made: Made, light: MeshLight | undefined): Made {
    return light ? { ...made, mesh: glowing(this.context, this.table, light, made.mesh) } : made;
  }

  private add(path: string, directions: Directions, { mesh, motion }: Made, lifetime: Lifetime): void {
    this.objects.push({ path, mesh, motion, lifetime, authoredIn: authoredInOf(directions) });
  }

  private shapeOf(prim: PrimSpec, surface: Surface): Shape | undefined {
    if (prim.typeName !== 'Mesh') return implicitShape(this.context, prim, surface);
    const shape = meshShape(this.context, this.skeletons, prim, surface);
    if (shape && shape.mesh.indices.length > 0) return shape;
    if (shape) report(this.context, 'warning', 'usd.empty-mesh', prim.path, 'the mesh has no faces; it is left out');
    return undefined;
  }

  private placed(path: string, shape: Shape, frame: Frame, directions: Directions): Made {
    const poseTime = poseTimeOf(directions);
    if (poseTime === undefined) return placeShape(this.context, path, shape, frame);
    if (frame.times.length > 0 || shape.deformation) {
      const message = `slowlight:motion and time samples both move it; it keeps its pose of t = ${poseTime} s and moves as slowlight:motion says`;
      report(this.context, 'warning', 'usd.slowlight', path, message);
    }
    const still = placeStill(this.context, shape, frame, poseTime * this.context.codesPerSecond);
    return { mesh: still.mesh, motion: directedMotion(this.context, path, still.motion.pose, directions) };
  }
}

type Made = Pick<SceneObject, 'mesh' | 'motion'>;

/** Whether several of its children have transforms of their own, or children that may have. */
const holdsFrames = ({ children }: PrimSpec): boolean =>
  [...children.values()].filter((child) => child.children.size > 0 || child.properties.has('xformOpOrder')).length > 1;

/** What stands for something else, or helps those who edit, is not looked at. */
const isDrawn = (purpose: string): boolean => purpose !== 'proxy' && purpose !== 'guide';
