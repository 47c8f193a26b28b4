import {
  SHADER_CHANNELS,
  type ShaderChannel,
  type ShaderInput,
  type ShaderProgram,
} from '../../../scene/shaderText/program.ts';
import { runShaderProgram } from '../../../scene/shaderText/run.ts';
import type { FloatImage, GBufferReader } from './effectInput.ts';

/** Applies a user-written effect (scene/shaderText/). `time`: world time of the observer [s]. */
export const applyShaderText = (
  program: ShaderProgram,
  frame: GBufferReader,
  args: readonly number[],
  time: number,
): FloatImage =>
  frame.image.map((x, y) => {
    const pixelInputs = {
      look: (channel: ShaderChannel, dx: number, dy: number) => readChannel(frame, channel, x + dx, y + dy),
      input: (name: ShaderInput) => inputOf(frame, name, x, y, args, time),
    };
    return runShaderProgram(program, pixelInputs).slice(0, 3);
  });

/** A channel's values at a pixel; 0 where no surface is. */
function readChannel(frame: GBufferReader, channel: ShaderChannel, x: number, y: number): readonly number[] {
  if (channel === 'image') return [...frame.image.at(x, y), 1];
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
    default:
      return [args[Number(name.slice(3)) - 1] ?? 0];
  }
}
