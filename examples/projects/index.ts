import type { GraphDocument } from '../../src/graph/document.ts';
import { letters } from './letters.ts';
import { workshop } from './workshop.ts';

/** Every example project, by name: a new one is added here. */
export const projects: Readonly<Record<string, () => GraphDocument>> = { letters, workshop };
