import type { Light, Scene, SceneCamera, SceneObject } from '../../scene/types.ts';
import { attributeOf, sampleTimes, textAt } from './attributes.ts';
import { cameraOf } from './cameras.ts';
import { isActive } from './compose/stage.ts';
import { metadataText, report, type StageContext } from './context.ts';
import { noteUnreadValues, UNREAD_TYPES } from './coverage.ts';
import { childFrame, type Frame, ROOT_FRAME } from './frame.ts';
import { implicitShape, isImplicit } from './gprims.ts';
import type { PrimSpec } from './layer.ts';
import { isLight, isUnreadLight, lightOf } from './lights.ts';
import { MaterialTable } from './materials.ts';
import { meshShape } from './meshes.ts';
import { geometryLights, glowing } from './meshLights.ts';
import { placeShape, placeStill, type Shape } from './placement.ts';
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
import { transformOf } from './xformOps.ts';

/** What a prim hands down to its children. */
interface Inherited {
  readonly frame: Frame;
  readonly binding: Binding | undefined;
  readonly directions: Directions;
  /** Of the nearest prim above that says what it is for. */
  readonly purpose: string;
}

export type StageContents = Pick<Scene, 'objects' | 'materials' | 'lights' | 'cameras'>;

/** Turns the defined, active, visible prims of a stage into what is observed. */
export async function readStage(context: StageContext): Promise<StageContents> {
  const reader = new StageReader(context);
  for (const prim of context.layer.rootPrims.values())
    await reader.visit(prim, { frame: ROOT_FRAME, binding: undefined, directions: {}, purpose: 'default' });
  return { objects: reader.objects, materials: reader.table.materials, lights: reader.lights, cameras: reader.cameras };
}

class StageReader {
  readonly objects: SceneObject[] = [];
  readonly lights: Light[] = [];
  readonly cameras: SceneCamera[] = [];
  readonly table: MaterialTable;
  private readonly context: StageContext;
  private readonly textures: TextureLoader;
  private readonly geometryLights: ReadonlyMap<string, PrimSpec>;

  constructor(context: StageContext) {
    this.context = context;
    this.textures = new TextureLoader(context);
    this.table = new MaterialTable(context, this.textures);
    this.geometryLights = geometryLights(context.layer.rootPrims.values());
  }

  async visit(prim: PrimSpec, inherited: Inherited): Promise<void> {
    if (!this.isThere(prim)) return;
    const own = this.inherit(prim, inherited);
    if (isDrawn(own.purpose)) await this.readHere(prim, own);
    // What is under an instancer is its prototypes, which are nowhere themselves.
    if (prim.typeName === 'PointInstancer') return;
    for (const child of prim.children.values()) await this.visit(child, own);
  }

  private async readHere(prim: PrimSpec, own: Inherited): Promise<void> {
    noteUnreadValues(this.context, prim);
    const unread =
      UNREAD_TYPES.get(prim.typeName) ?? (isUnreadLight(prim.typeName) ? 'is a light that is not read' : undefined);
    if (unread) report(this.context, 'warning', 'usd.unsupported-prim', prim.path, `${prim.typeName} ${unread}`);
    await this.read(prim, own);
  }

  private isThere(prim: PrimSpec): boolean {
    if (prim.specifier === 'class' || !isActive(prim)) return false;
    if (prim.specifier === 'over') {
      const message = "an 'over' changes this prim, and nothing defines it; it is left out";
      report(this.context, 'warning', 'usd.undefined-prim', prim.path, message);
      return false;
    }
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
    const transform = transformOf(prim);
    for (const name of transform.unknown)
      report(
        this.context,
        'warning',
        'usd.xform-op',
        prim.path,
        `xformOpOrder names '${name}', which is no transform of this prim; it is left out`,
      );
    const directions = directionsOf(prim, inherited.directions);
    if (directions !== inherited.directions) checkDirections(this.context, prim.path, directions);
    return {
      frame: childFrame(transform.resetsStack ? ROOT_FRAME : inherited.frame, transform.ops),
      binding: bindingOf(prim, inherited.binding),
      directions,
      purpose: textAt(prim, 'purpose', undefined) ?? inherited.purpose,
    };
  }

  private async read(prim: PrimSpec, own: Inherited): Promise<void> {
    if (prim.typeName === 'Camera') this.cameras.push(cameraOf(this.context, prim, own.frame));
    else if (isLight(prim.typeName))
      this.lights.push(await lightOf(this.context, this.textures, prim, own.frame, own.directions));
    else if (prim.typeName === 'Mesh' || isImplicit(prim.typeName)) await this.readObject(prim, own);
  }

  private async readObject(prim: PrimSpec, own: Inherited): Promise<void> {
    const surface = await surfaceOf(this.context, this.table, prim, own.binding);
    const shape = this.shapeOf(prim, surface);
    if (!shape) return;
    const { mesh, motion } = this.placed(prim, shape, own);
    this.objects.push({
      path: prim.path,
      mesh: glowing(this.context, this.table, prim, mesh, this.geometryLights),
      motion,
      lifetime: lifetimeOf(own.directions),
      authoredIn: authoredInOf(own.directions),
    });
  }

  private shapeOf(prim: PrimSpec, surface: Surface): Shape | undefined {
    if (prim.typeName !== 'Mesh') return implicitShape(this.context, prim, surface);
    const shape = meshShape(this.context, prim, surface);
    if (shape && shape.mesh.indices.length > 0) return shape;
    if (shape) report(this.context, 'warning', 'usd.empty-mesh', prim.path, 'the mesh has no faces; it is left out');
    return undefined;
  }

  private placed(prim: PrimSpec, shape: Shape, own: Inherited): Pick<SceneObject, 'mesh' | 'motion'> {
    const poseTime = poseTimeOf(own.directions);
    if (poseTime === undefined) return placeShape(this.context, prim.path, shape, own.frame);
    if (own.frame.times.length > 0 || shape.deformation) {
      const message = `slowlight:motion and time samples both move it; it keeps its pose of t = ${poseTime} s and moves as slowlight:motion says`;
      report(this.context, 'warning', 'usd.slowlight', prim.path, message);
    }
    const still = placeStill(this.context, shape, own.frame, poseTime * this.context.codesPerSecond);
    return { mesh: still.mesh, motion: directedMotion(this.context, prim.path, still.motion.pose, own.directions) };
  }
}

/** What stands for something else, or helps those who edit, is not looked at. */
const isDrawn = (purpose: string): boolean => purpose !== 'proxy' && purpose !== 'guide';

/** The layer's up axis; USD's own fallback is Y. */
export const upAxisOf = (context: Pick<StageContext, 'layer'>): 'Y' | 'Z' =>
  metadataText(context.layer.metadata, 'upAxis') === 'Z' ? 'Z' : 'Y';
