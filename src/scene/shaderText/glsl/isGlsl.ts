import { SHADER_TEXT_LIMITS } from '../sourceLocation.ts';

const COMMENTS = /\/\*[\s\S]*?\*\/|\/\/[^\n]*/g;

/** Whether a text is GLSL: it begins with `#version`, or has a `void main()`. */
export const isGlsl = (text: string): boolean =>
  /^\s*#\s*version\b|\bvoid\s+main\s*\(/m.test(text.slice(0, SHADER_TEXT_LIMITS.length).replace(COMMENTS, ' '));
