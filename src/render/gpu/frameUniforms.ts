import { uniform } from 'three/tsl';
import { Matrix3, Vector2, Vector3 } from 'three/webgpu';
import { backdropColors } from '../../scene/lights/sceneLights.ts';
import { makeLensUniforms } from '../lenses/lensUniforms.ts';
import { makeObserverUniforms } from './observerUniforms.ts';

const DAY = backdropColors({ lights: [] });

/** Uniforms that all passes of a picture read, written once per picture. */
export function makeFrameUniforms() {
  return {
    ...makeObserverUniforms(),
    iterations: uniform(1, 'int'),
    damping: uniform(1),
    /** 1 in views that show events on the past light cone, otherwise 0. */
    onLightCone: uniform(1),
    /** 1 in the view from slice to cone between its ends, otherwise 0. */
    onShallowCone: uniform(0),
    /** 1 if distances are those of light, |Δx′| = D|Δx|, otherwise 0. */
    boosted: uniform(1),
    /** 1 if surfaces are lit in their rest frame, 0 in views that are not luminous. */
    boostLight: uniform(1),
    /** 1 if light travels from lamps to surfaces at finite speed, 0 in views of one moment. */
    lightTravels: uniform(1),
    /** The settings' Doppler shift of colours and beaming; 0 in views that are not luminous. */
    dopplerMix: uniform(1),
    beaming: uniform(1),
    exposure: uniform(0),
    /** 1/c */
    secondsPerMetre: uniform(0),
    /** Half the width and height of the picture at distance 1, and where its centre is there (`Frustum` of scene/view/lens.ts). */
    halfTangents: uniform(new Vector2(1, 1)),
    frustumCenter: uniform(new Vector2()),
    lens: makeLensUniforms(),
    /** Offset of this sample within its pixel, in half-pictures (NDC). */
    jitter: uniform(new Vector2()),
    /** Side of the part of a pixel that this sample stands for: 1 of a single sample, 1/n of n × n. */
    footprint: uniform(1),
    /** From the camera to the observer, on its axes (`OutsideCamera`) [m]. */
    toObserver: uniform(new Vector3()),
    /** Camera axes → world axes carried by the boost. */
    orientation: uniform(new Matrix3()),
    /** Unit, world frame. */
    zenith: uniform(new Vector3(0, 1, 0)),
    /** Colours of the scene's sky as a backdrop, linear sRGB. */
    skyZenith: uniform(new Vector3(...DAY.zenith)),
    skyHorizon: uniform(new Vector3(...DAY.horizon)),
    skyGround: uniform(new Vector3(...DAY.ground)),
    /** Height of the observer above the ground [m], and its coordinates along the ground's two axes, modulo ten grid steps. */
    ground: uniform(new Vector3()),
    gridStep: uniform(1),
    gridEast: uniform(new Vector3(1, 0, 0)),
    gridNorth: uniform(new Vector3(0, 0, 1)),
    /** Weight of the new sample in the accumulated picture. */
    weight: uniform(1),
    firstSample: uniform(1),
  };
}

export type FrameUniforms = ReturnType<typeof makeFrameUniforms>;
