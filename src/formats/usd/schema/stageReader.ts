import { IDENTITY, invert } from '../../../math/mat4.ts';
import { msg } from '../../../messages/message.ts';
import { bakedObject } from '../../../scene/mesh/stretch.ts';
import { isAtOrBelow } from '../../../scene/motion/fly.ts';
import { commonLifetimes, isAlive, isEternal } from '../../../scene/motion/lifetimes.ts';
import type { Lifetime, Light, Scene, SceneCamera, SceneObject } from '../../../scene/types.ts';
import { MAX_OBJECTS } from '../../read/limits.ts';
import { settleStretches } from '../../read/stretches.ts';
import { report } from '../diagnostics.ts';
import { type TimeCode, textAt } from '../layer/attributes.ts';
import type { PrimSpec } from '../layer/layer.ts';
import { parentOf } from '../layer/primPaths.ts';
import { ancestorsOf, isActive } from '../layer/query.ts';
import { cameraOf } from './cameras.ts';
import type { StageContext } from './context.ts';
import { gprimGeometry, isGprim } from './geometry/gprims.ts';
import { meshGeometry } from './geometry/meshes.ts';
import type { PrimGeometry } from './geometry/primGeometry.ts';
import { PrimGeometryCache, withMaterialReplaced } from './geometry/primGeometryCache.ts';
import type { InstanceContext, Instancers } from './instancer/instancers.ts';
import type { PlacedInstancer, Prototype, UnplacedGprim } from './instancer/prototype.ts';
import { collectPrototypePaths } from './instancer/prototypePaths.ts';
import { isLight, isUnreadLight, lightOf } from './lights/lights.ts';
import { geometryLights, type MeshLight, meshLightOf, withEmission } from './lights/meshLights.ts';
import type { NumberedPiece } from './lives/livingPieces.ts';
import type { MeshPiece } from './lives/meshPieces.ts';
import { piecePaths } from './lives/piecePaths.ts';
import { isTopologySampled } from './lives/topology.ts';
import { ALWAYS, visibleTimes } from './lives/visibility.ts';
import {
  type MaterialBinding,
  materialBindingOf,
  type PrimMaterials,
  primMaterialsOf,
} from './materials/materialBinding.ts';
import { MaterialTable } from './materials/materialTable.ts';
import { TextureLoader } from './materials/textureLoader.ts';
import { placeAtTime, placeGeometry, placeWithVelocity } from './placement/placement.ts';
import { maybeSkinned } from './skel/maybeSkinned.ts';
import type { Skins } from './skel/skin.ts';
import {
  authoredInOf,
  checkSlowlightAttributes,
  closedFormMotion,
  lifetimeOf,
  poseTimeOf,
  type SlowlightAttributes,
  slowlightAttributesOf,
} from './slowlightAttributes.ts';
import {
  childTransform,
  localToStageTransform,
  nestedTransform,
  ROOT_TRANSFORM,
  type StageTransform,
} from './transforms/stageTransform.ts';
import { MAX_OPS, transformOf } from './transforms/xformOps.ts';
import { reportUnreadValues, unreadType } from './unreadSchemas.ts';

/** State inherited by child prims. */
interface Inherited {
  readonly transform: StageTransform;
  readonly material: MaterialBinding | undefined;
  readonly slowlight: SlowlightAttributes;
  /** May be skinned. */
  readonly maybeSkinned: boolean;
  /** Inherited `purpose`. */
  readonly purpose: string;
  /** When it is visible [s]. */
  readonly lives: readonly Lifetime[];
  /** Receives the gprims: the scene, or a prototype. */
  readonly sink: GprimSink;
}

interface GprimSink {
  /** Only the scene receives lights and cameras. */
  readonly isScene: boolean;
  gprim(part: UnplacedGprim): void;
  instancer(site: PlacedInstancer): Promise<void>;
}

const AT_ROOT = {
  transform: ROOT_TRANSFORM,
  material: undefined,
  slowlight: {},
  maybeSkinned: false,
  purpose: 'default',
  lives: ALWAYS,
};

export type StageContents = Pick<Scene, 'objects' | 'materials' | 'lights' | 'cameras'>;

/** Reads the defined, active, visible prims of a stage to a scene. */
export async function readStage(context: StageContext): Promise<StageContents> {
  const reader = new StageReader(context);
  for (const prim of context.layer.rootPrims.values()) await reader.visit(prim, { ...AT_ROOT, sink: reader.scene });
  return {
    objects: settleStretches(reader.objects),
    materials: reader.table.materials,
    lights: reader.lights,
    cameras: reader.cameras,
  };
}

class StageReader {
  readonly objects: SceneObject[] = [];
  readonly lights: Light[] = [];
  readonly cameras: SceneCamera[] = [];
  readonly table: MaterialTable;
  private readonly context: StageContext;
  readonly scene: GprimSink;
  private readonly textures: TextureLoader;
  private readonly geometryLights: ReadonlyMap<string, PrimSpec>;
  private readonly geometryCache = new PrimGeometryCache();
  /** Paths of prototypes and their ancestors, which need not be defined. */
  private readonly prototypes: ReadonlySet<string>;
  private instancers: Promise<Instancers> | undefined;
  private skins: Promise<Skins> | undefined;

  constructor(context: StageContext) {
    this.context = context;
    this.textures = new TextureLoader(context);
    this.table = new MaterialTable(context, this.textures);
    this.geometryLights = geometryLights(context.layer.rootPrims.values());
    this.prototypes = collectPrototypePaths(context.layer.rootPrims, new Set());
    this.scene = {
      isScene: true,
      gprim: (part) => this.draw(part),
      instancer: async (site) => {
        this.instancers ??= this.loadInstancers();
        await (await this.instancers).expand(site);
      },
    };
  }

  private async loadInstancers(): Promise<Instancers> {
    const { Instancers } = await import('./instancer/instancers.ts');
    return new Instancers(this.context, {
      prototype: (prim) => this.subtree(prim),
      addInstance: (part, path, setting) => this.drawInstance(part, path, setting),
      remainingObjects: () => MAX_OBJECTS - this.objects.length,
    });
  }

  private async loadSkins(): Promise<Skins> {
    const { Skins } = await import('./skel/skin.ts');
    return new Skins(this.context);
  }

  async visit(prim: PrimSpec, inherited: Inherited): Promise<void> {
    if (inherited.sink.isScene && !this.isAsked(prim.path, 'leadsTo')) return;
    if (this.isDefined(prim)) await this.readVisible(prim, inherited);
  }

  /** Reads a prim and its subtree if it is ever visible. */
  private async readVisible(prim: PrimSpec, inherited: Inherited): Promise<void> {
    const lives = visibleTimes(this.context, prim, inherited.lives);
    if (lives.length > 0) await this.read(prim, { ...this.inherit(prim, inherited), lives });
  }

  /** Reads a defined prim and its subtree. */
  private async read(prim: PrimSpec, own: Inherited): Promise<void> {
    const drawn = isRendered(own.purpose) && (!own.sink.isScene || this.isAsked(prim.path, 'isPart'));
    if (drawn) await this.readHere(prim, own);
    // Prims below an instancer are its prototypes, not rendered themselves.
    if (prim.typeName === 'PointInstancer') {
      if (drawn)
        await own.sink.instancer({ prim, transform: own.transform, slowlight: own.slowlight, lives: own.lives });
      return;
    }
    for (const child of prim.children.values()) await this.visit(child, own);
  }

  /** Whether a prim is part of what is asked for, or also leads to it. */
  private isAsked(path: string, how: 'isPart' | 'leadsTo'): boolean {
    const asked = this.context.prim;
    if (asked === undefined || isAtOrBelow(path, asked)) return true;
    return how === 'leadsTo' && isAtOrBelow(asked, path);
  }

  /** Reads a prototype, defined or not; its materials are bound by its place in the stage. */
  private async subtree(prim: PrimSpec): Promise<Prototype> {
    const parts: UnplacedGprim[] = [];
    const instancers: PlacedInstancer[] = [];
    const found: GprimSink = {
      isScene: false,
      gprim: (part) => parts.push(part),
      instancer: async (site) => {
        instancers.push(site);
      },
    };
    const parentPath = parentOf(prim.path);
    const above = ancestorsOf(this.context.layer, prim.path);
    const binding = above.reduce<MaterialBinding | undefined>(
      (around, ancestor) => materialBindingOf(ancestor, around),
      undefined,
    );
    const bound = above.reduce((around, ancestor) => maybeSkinned(ancestor, around), false);
    if (isActive(prim))
      await this.readVisible(prim, { ...AT_ROOT, material: binding, maybeSkinned: bound, sink: found });
    return { parentPath, gprims: parts, instancers };
  }

  private async readHere(prim: PrimSpec, own: Inherited): Promise<void> {
    reportUnreadValues(this.context, prim);
    const { typeName } = prim;
    const unread = isUnreadLight(typeName) ? msg`${typeName} is a light that is not read` : unreadType(typeName);
    if (unread) report(this.context, 'warning', 'usd.unsupported-prim', prim.path, unread);
    await this.readSchema(prim, own);
  }

  private isDefined(prim: PrimSpec): boolean {
    if (prim.specifier === 'class' || !isActive(prim)) return false;
    if (prim.specifier === 'over') {
      const message = msg`an 'over' changes this prim, and nothing defines it; it is left out`;
      if (!this.prototypes.has(prim.path)) report(this.context, 'warning', 'usd.undefined-prim', prim.path, message);
      return false;
    }
    return true;
  }

  private inherit(prim: PrimSpec, inherited: Inherited): Omit<Inherited, 'lives'> {
    const transform = transformOf(prim, this.context.cubic);
    for (const name of transform.unknown)
      report(
        this.context,
        'warning',
        'usd.xform-op',
        prim.path,
        msg`xformOpOrder names '${name}', which is no transform of this prim; it is left out`,
      );
    if (transform.tooMany) {
      const message = msg`xformOpOrder names ${transform.tooMany} transforms; the first ${MAX_OPS} are used (write their product as one matrix)`;
      report(this.context, 'warning', 'usd.xform-op', prim.path, message);
    }
    const directions = slowlightAttributesOf(prim, inherited.slowlight);
    if (directions !== inherited.slowlight) checkSlowlightAttributes(this.context, prim.path, directions);
    return {
      transform: childTransform(
        transform.resetsStack ? ROOT_TRANSFORM : inherited.transform,
        transform.ops,
        hasSeveralTransforms(prim),
      ),
      material: materialBindingOf(prim, inherited.material),
      slowlight: directions,
      maybeSkinned: maybeSkinned(prim, inherited.maybeSkinned),
      purpose: textAt(prim, 'purpose', undefined) ?? inherited.purpose,
      sink: inherited.sink,
    };
  }

  private async readSchema(prim: PrimSpec, own: Inherited): Promise<void> {
    const lights = isLight(prim.typeName);
    if ((lights || prim.typeName === 'Camera') && !own.sink.isScene) {
      const message = msg`a ${prim.typeName} in a prototype of instances is not read; it is left out`;
      report(this.context, 'warning', 'usd.instancer', prim.path, message);
    } else if (prim.typeName === 'Camera') this.cameras.push(cameraOf(this.context, prim, own.transform));
    else if (lights) await this.readLight(prim, own);
    else if (prim.typeName === 'Mesh' || isGprim(prim.typeName) || STRANDS.has(prim.typeName))
      await this.readGprim(prim, own);
  }

  private async readLight(prim: PrimSpec, { transform: frame, slowlight, lives }: Inherited): Promise<void> {
    const { context, textures } = this;
    const light = await lightOf({ context, textures, prim, frame, slowlight });
    if ('lifetime' in light) {
      const own = livesIn(lives, light.lifetime);
      piecePaths(prim.path, undefined, own.length).forEach((piece, i) => {
        this.lights.push({ ...light, ...piece, lifetime: own[i] });
      });
      return;
    }
    if (lives !== ALWAYS) {
      const message = msg`its visibility changes with time, and a ${prim.typeName} has no lifetime: it is held at the start`;
      report(context, 'warning', 'usd.animated-visibility', prim.path, message);
    }
    if (lives.some((life) => isAlive(life, context.startCode / context.codesPerSecond))) this.lights.push(light);
  }

  private async readGprim(prim: PrimSpec, own: Inherited): Promise<void> {
    const pieces = prim.typeName === 'Mesh' && isTopologySampled(prim) ? await this.piecesOf(prim, own) : undefined;
    if (!pieces) await this.readShape(prim, own);
    else for (const { piece, life } of pieces) await this.readShape(prim, { ...own, ...life }, piece);
  }

  private async piecesOf(prim: PrimSpec, own: Inherited) {
    const { livingPieces } = await import('./lives/livingPieces.ts');
    return livingPieces(this.context, prim, own);
  }

  private async readShape(prim: PrimSpec, own: Inherited, piece?: NumberedPiece): Promise<void> {
    const { material, transform, slowlight, sink, lives } = own;
    const context = piece ? { ...this.context, startCode: piece.at } : this.context;
    const surface = await primMaterialsOf(context, this.table, prim, material);
    if (own.maybeSkinned) this.skins ??= this.loadSkins();
    const skins = own.maybeSkinned ? await this.skins : undefined;
    const make = () => this.geometryOf(context, prim, surface, { skins, piece });
    // A skinned mesh's shape depends on more than its own opinions.
    const which = `${piece?.at ?? ''}`;
    const shape = await (own.maybeSkinned ? make() : this.geometryCache.getOrCreate(prim, surface, which, make));
    if (!shape) return;
    const place =
      shape.transform && !sink.isScene
        ? this.transformInPrototype(prim, transform, shape.transform)
        : (shape.transform ?? transform);
    const light = meshLightOf(prim, this.geometryLights);
    const part = {
      path: prim.path,
      geometry: shape,
      transform: place,
      slowlight,
      lives,
      displayColorMaterial: surface.displayColorMaterial,
    };
    sink.gprim({ ...part, ...(light && { light }), ...(piece?.number !== undefined && { piece: piece.number }) });
  }

  /** The stage transform `target` carried along to where `frame` places the prim: frame × (the prim's own stage transform)⁻¹ × target. */
  private transformInPrototype(prim: PrimSpec, frame: StageTransform, target: StageTransform): StageTransform {
    const own = localToStageTransform(this.context.layer, prim.path);
    const back = { ...own, matrixAt: (time: TimeCode) => invert(own.matrixAt(time)) ?? IDENTITY };
    return nestedTransform(frame, nestedTransform(back, target));
  }

  private draw(part: UnplacedGprim): void {
    const { path, geometry, transform, slowlight, light } = part;
    const placed = this.placed(path, geometry, transform, slowlight);
    this.add(path, part, slowlight, this.withMeshLight(placed, light), livesIn(part.lives, lifetimeOf(slowlight)));
  }

  private drawInstance(part: UnplacedGprim, path: string, setting: InstanceContext): void {
    const lives = livesIn(commonLifetimes(setting.lives, part.lives), lifetimeOf(setting.slowlight));
    if (lives.length === 0 || this.objects.length >= MAX_OBJECTS) return;
    const frame = nestedTransform(setting.transform, part.transform);
    const placed = setting.velocity
      ? placeWithVelocity(this.context, path, part.geometry, frame, setting.velocity)
      : this.placed(path, part.geometry, frame, setting.slowlight);
    const { color } = setting;
    const mesh =
      color && part.displayColorMaterial !== undefined
        ? withMaterialReplaced(
            placed.mesh,
            part.displayColorMaterial,
            this.table.withBaseColor(part.displayColorMaterial, color),
          )
        : placed.mesh;
    this.add(path, part, setting.slowlight, this.withMeshLight({ ...placed, mesh }, part.light), lives);
  }

  private withMeshLight(made: ObjectGeometry, light: MeshLight | undefined): ObjectGeometry {
    if (!light) return made;
    // What a square metre of it emits depends on its size.
    const baked = bakedObject(made);
    return { ...baked, mesh: withEmission(this.context, this.table, light, baked.mesh) };
  }

  private add(
    path: string,
    { piece }: Pick<UnplacedGprim, 'piece'>,
    directions: SlowlightAttributes,
    geometry: ObjectGeometry,
    lives: readonly Lifetime[],
  ): void {
    const room = Math.max(1, MAX_OBJECTS - this.objects.length);
    if (lives.length > room) {
      const message = msg`it exists at ${lives.length} separate times, and a scene has room for ${room} more objects; the first are shown`;
      report(this.context, 'warning', 'usd.too-many-instances', path, message);
    }
    piecePaths(path, piece, Math.min(lives.length, room)).forEach((named, i) => {
      this.objects.push({ ...named, ...geometry, lifetime: lives[i], authoredIn: authoredInOf(directions) });
    });
  }

  private async geometryOf(
    context: StageContext,
    prim: PrimSpec,
    surface: PrimMaterials,
    { skins, piece }: { readonly skins: Skins | undefined; readonly piece: MeshPiece | undefined },
  ): Promise<PrimGeometry | undefined> {
    if (STRANDS.has(prim.typeName)) {
      const { strandGeometry } = await import('./strands/strandGeometry.ts');
      return carriedBy(skins, prim, strandGeometry(context, prim, surface));
    }
    if (prim.typeName !== 'Mesh') return carriedBy(skins, prim, gprimGeometry(context, prim, surface));
    const shape = await meshGeometry(context, skins, prim, surface, piece);
    if (shape && shape.mesh.indices.length > 0) return shape;
    if (shape) report(context, 'warning', 'usd.empty-mesh', prim.path, msg`the mesh has no faces; it is left out`);
    return undefined;
  }

  private placed(
    path: string,
    shape: PrimGeometry,
    frame: StageTransform,
    directions: SlowlightAttributes,
  ): ObjectGeometry {
    const poseTime = poseTimeOf(directions);
    if (poseTime === undefined) return placeGeometry(this.context, path, shape, frame);
    if (frame.times.length > 0 || shape.deformation) {
      const message = msg`slowlight:motion and time samples both move it; it keeps its pose of t = ${poseTime} s and moves as slowlight:motion says`;
      report(this.context, 'warning', 'usd.slowlight', path, message);
    }
    const still = placeAtTime(this.context, shape, frame, poseTime * this.context.codesPerSecond);
    return { ...still, motion: closedFormMotion(this.context, path, still.motion.pose, directions) };
  }
}

/** A shape where the joints that it follows as a whole bring it. */
function carriedBy<Shape extends PrimGeometry | undefined>(
  skins: Skins | undefined,
  prim: PrimSpec,
  shape: Shape,
): Shape {
  const transform = shape && skins?.frameOf(prim);
  return transform ? { ...shape, transform } : shape;
}

type ObjectGeometry = Pick<SceneObject, 'mesh' | 'stretch' | 'motion'>;

/** The lives within an authored lifetime; that itself if it is empty, for the validation to tell of. */
const livesIn = (lives: readonly Lifetime[], authored: Lifetime): readonly Lifetime[] => {
  if (isEternal(authored)) return lives;
  return authored.birth < authored.death ? commonLifetimes(lives, [authored]) : [authored];
};

/** Points and curves, which are drawn as surfaces. */
const STRANDS = new Set(['Points', 'BasisCurves', 'NurbsCurves']);

/** Whether several of its children have transforms of their own, or children that may have. */
const hasSeveralTransforms = ({ children }: PrimSpec): boolean =>
  [...children.values()].filter((child) => child.children.size > 0 || child.properties.has('xformOpOrder')).length > 1;

/** Proxies and guides are not rendered. */
const isRendered = (purpose: string): boolean => purpose !== 'proxy' && purpose !== 'guide';
