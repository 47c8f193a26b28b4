import type { Vec3 } from '../../math/vec3.ts';
import type { Scene } from '../../scene/types.ts';

/** Parts of what is to be simulated, as plain data that other threads can use. World frame, SI units. */
export type Matter = MassSpringMatter | ColliderMatter | FieldMatter;

interface MatterBase {
  /** The node that describes it, for messages. */
  readonly node: string;
}

/** Objects whose vertices have masses, with springs between them. */
export interface MassSpringMatter extends MatterBase, InitialConditions {
  readonly kind: 'net';
  /** Only the objects, at rest. */
  readonly scene: Scene;
  /** [N/m]; 0: no springs of that kind. */
  readonly stiffness: {
    readonly structural: number;
    readonly shear: number;
    readonly bending: number;
    /** From each point to the center of its object. */
    readonly filling: number;
  };
  /** Rest length of springs as a fraction of their initial length. */
  readonly tension: number;
  readonly pins: PinSelection;
  /** About the center of each object [rad/s]. */
  readonly spin: Vec3;
}

/** Initial conditions of each object. */
export interface InitialConditions {
  /** Per object [kg]. */
  readonly mass: number;
  /** [m/s] */
  readonly velocity: Vec3;
  /** Per object [C]. */
  readonly charge: number;
}

/** Which points are pinned. */
export type PinSelection =
  | { readonly kind: 'none' | 'corners' | 'top' }
  | { readonly kind: 'box'; readonly center: Vec3; readonly size: Vec3 }
  /** Vertices of each object's mesh. */
  | { readonly kind: 'points'; readonly vertices: readonly number[] };

/** Objects that nothing penetrates. */
export interface ColliderMatter extends MatterBase {
  readonly kind: 'solid';
  /** Only the objects, at rest. */
  readonly scene: Scene;
  readonly shape: 'plane' | 'box' | 'ball';
  /** [N/m] */
  readonly stiffness: number;
  /** Contact radius of a sphere relative to its displayed radius. */
  readonly scale: number;
  /** Distance that planes and boxes keep [m]. */
  readonly margin: number;
  /** Per object [C]. */
  readonly charge: number;
  /** For dynamic spheres; absent: fixed. */
  readonly free?: Omit<InitialConditions, 'charge'> & { readonly rods?: Rods };
}

/** Stiff springs that hold spheres like rods. */
export interface Rods {
  /** `pivot`: each sphere hangs on a rod of its own; `chain`: the first on the pivot, every other on the one before. */
  readonly to: 'pivot' | 'chain';
  /** From a sphere's center to its pivot, which is fixed [m]. */
  readonly pivot: Vec3;
  /** [N/m] */
  readonly stiffness: number;
  /** Displayed thickness [m]; 0: not displayed. */
  readonly thickness: number;
}

/** Fields that act on everything that moves. */
export interface FieldMatter extends MatterBase {
  readonly kind: 'field';
  /** [m/s²] */
  readonly gravity: Vec3;
  /** [V/m] */
  readonly electric: Vec3;
  /** [T] */
  readonly magnetic: Vec3;
  /** [1/s] */
  readonly drag: number;
  /** Whether charges act on each other. */
  readonly coulomb: boolean;
}
