import {
  PROJECTION_NEAR,
  SHADER_CHANNELS,
  type ShaderChannel,
  type ShaderInput,
  type ShaderProgram,
} from '../../../scene/shaderText/program.ts';
import { runShaderProgram } from '../../../scene/shaderText/run.ts';
import type { Frustum } from '../../../scene/view/lenses/perspectiveLens.ts';
import type { FloatImage, GBufferReader } from './effectInput.ts';

/** Applies a user-written effect (scene/shaderText/). `time`: world time of the observer [s]. */
export const applyShaderText = (
  program: ShaderProgram,
  frame: GBufferReader,
  args: readonly number[],
  time: number,
  second?: FloatImage,
): FloatImage =>
  frame.image.map((x, y) => {
    const pixelInputs = {
      look: (channel: ShaderChannel, dx: number, dy: number) => readChannel(frame, channel, x + dx, y + dy, second),
      input: (name: ShaderInput) => inputOf(frame, name, x, y, args, time),
    };
    return runShaderProgram(program, pixelInputs).slice(0, 3);
  });

/** A channel's values at a pixel; 0 where no surface is. */
function readChannel(
  frame: GBufferReader,
  channel: ShaderChannel,
  x: number,
  y: number,
  second: FloatImage | undefined,
): readonly number[] {
  if (channel === 'image') return [...frame.image.at(x, y), 1];
  if (channel === 'image2') return [...(second?.at(x, y) ?? [0, 0, 0]), 1];
  if (!frame.isCovered(x, y)) return Array.from({ length: SHADER_CHANNELS[channel] }, () => 0);
  switch (channel) {
    case 'there':
      return [1];
    case 'depth':
      return [frame.depth(x, y)];
    case 'normal':
      return frame.normal(x, y);
    case 'event':
      return frame.eventOffset(x, y);
    case 'apparent':
      return frame.apparentPosition(x, y);
    case 'clipDepth':
      return [1 - (2 * PROJECTION_NEAR) / frame.axialDepth(x, y)];
    case 'metallicRoughness':
      return [...frame.read('metallic', x, y), ...frame.read('roughness', x, y)];
    case 'emissionTime':
      return [frame.emissionTime(x, y)];
    default:
      return frame.read(channel, x, y);
  }
}

function inputOf(
  frame: GBufferReader,
  name: ShaderInput,
  x: number,
  y: number,
  args: readonly number[],
  time: number,
): readonly number[] {
  const { width, height } = frame.image;
  switch (name) {
    case 'time':
      return [time];
    case 'p.position':
      return [x + 0.5, y + 0.5];
    case 'p.uv':
      return [(x + 0.5) / width, (y + 0.5) / height];
    case 'p.size':
      return [width, height];
    case 'p.direction':
      return frame.direction(x, y);
    case 'p.view':
      return frame.viewMatrix;
    case 'p.projection':
      return projectionMatrix(frame.frustum);
    default:
      return [args[Number(name.slice(3)) - 1] ?? 0];
  }
}

/** Camera axes → clip space of OpenGL, column after column, without a far plane. */
function projectionMatrix({ tanX, tanY, center: [x, y] }: Frustum): readonly number[] {
  return [1 / tanX, 0, 0, 0, 0, 1 / tanY, 0, 0, x / tanX, y / tanY, -1, -1, 0, 0, -2 * PROJECTION_NEAR, 0];
}
