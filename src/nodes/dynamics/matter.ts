import type { Vec3 } from '../../math/vec3.ts';
import type { Scene } from '../../scene/types.ts';

/** What is to be simulated, by parts: descriptions, for other threads compute with them. World frame, SI units. */
export type Matter = MassSpringMatter | ColliderMatter | FieldMatter;

interface MatterBase {
  /** The node that describes it, for what is said of it. */
  readonly node: string;
}

/** Things whose points have masses, with springs between them. */
export interface MassSpringMatter extends MatterBase, InitialConditions {
  readonly kind: 'net';
  /** The things alone, at rest. */
  readonly scene: Scene;
  /** [N/m]; 0: no such springs. */
  readonly stiffness: {
    readonly structural: number;
    readonly shear: number;
    readonly bending: number;
    /** From each point to the middle of its thing. */
    readonly filling: number;
  };
  /** How long springs are at rest, of what they are at the start. */
  readonly tension: number;
  readonly pins: PinSelection;
  /** About the middle of each thing [rad/s]. */
  readonly spin: Vec3;
}

/** How each thing begins. */
export interface InitialConditions {
  /** Of each thing [kg]. */
  readonly mass: number;
  /** [m/s] */
  readonly velocity: Vec3;
  /** Of each thing [C]. */
  readonly charge: number;
}

/** Which points are held where they are. */
export type PinSelection =
  | { readonly kind: 'none' | 'corners' | 'top' }
  | { readonly kind: 'box'; readonly center: Vec3; readonly size: Vec3 }
  /** Vertices of the mesh of each thing. */
  | { readonly kind: 'points'; readonly vertices: readonly number[] };

/** Things that nothing gets into. */
export interface ColliderMatter extends MatterBase {
  readonly kind: 'solid';
  /** The things alone, at rest. */
  readonly scene: Scene;
  readonly shape: 'plane' | 'box' | 'ball';
  /** [N/m] */
  readonly stiffness: number;
  /** How much larger than it is shown a ball is for what it touches. */
  readonly scale: number;
  /** How far planes and boxes keep things off [m]. */
  readonly margin: number;
  /** Of each thing [C]. */
  readonly charge: number;
  /** Of balls that are moved by what they touch; absent: they stand fast. */
  readonly free?: Omit<InitialConditions, 'charge'> & { readonly rods?: Rods };
}

/** Springs as stiff as rods that hold balls. */
export interface Rods {
  /** Each by its own, or the first alone, and each other by the one before it. */
  readonly to: 'pivot' | 'chain';
  /** From a ball's middle to the fixed place that holds it [m]. */
  readonly pivot: Vec3;
  /** [N/m] */
  readonly stiffness: number;
  /** As they are drawn [m]; 0: they are not. */
  readonly thickness: number;
}

/** What acts on all that moves. */
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
  /** Charges act on each other. */
  readonly coulomb: boolean;
}
