import type { Node } from 'three/webgpu';

/** A truth value in a shader. */
export type Bool = Node<'bool'>;
/** An integer in a shader. */
export type Int = Node<'int'>;
/** A number in a shader (f32). */
export type Float = Node<'float'>;
export type Vec2 = Node<'vec2'>;
/** Three numbers in a shader (f32). */
export type Vec3 = Node<'vec3'>;
/** Four numbers in a shader (f32). */
export type Vec4 = Node<'vec4'>;

/*
 * Units and frames of every function in this folder: c = 1, lengths in metres, times in light-metres (c·t), world axes,
 * everything f32. u = γβ of the observer and γ = √(1 + u²) are uploaded as a pair, because f32 loses one from the other.
 *
 * To keep large numbers out of f32, every object has an anchor: per frame and object the CPU finds in f64 one event on (or near)
 * the object and on the hypersurface that is rendered (the observer's past light cone, or the slice of simultaneity).
 * `anchor` = (d_c, R) is that event, d_c from the observer to it and R = |d_c|; on the light cone its time is
 * −R. Positions and times of vertices and samples are uploaded relative to the anchor, and a solved time `s` is
 * relative to it too. docs/physics.md §4.9.
 */

/** The event at which a vertex is drawn, and its velocity there. */
export interface VertexEvent {
  /** Observer → event [m]. */
  readonly dx: Vec3;
  /** Time relative to the anchor's [light-metres]. */
  readonly s: Float;
  /** (v, 1 − v²), in units of c. */
  readonly velocity: Vec4;
}

/** The i-th sample of a vertex's world line: position and time relative to the anchor, (x, y, z, t); times increase. */
export type SampleTable = (index: Int) => Vec4;

/** A vertex event that may not exist: `exists` is false behind the horizon. */
export interface HyperbolicVertexEvent extends VertexEvent {
  /** False behind the horizon. */
  readonly exists: Bool;
}

/** A vertex's position [m] at a time [light-metres], both relative to the anchor, and its (v, 1 − v²) there. */
export type WorldLineAt = (time: Float) => { readonly x: Vec3; readonly velocity: Vec4 };
