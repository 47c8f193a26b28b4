import { createRoot } from 'react-dom/client';
import { startEditor } from '../editor/start.tsx';
import { lessonPlaceOf } from '../lessons/lessonAddress.ts';

const parameters = new URLSearchParams(location.search);
const wanted = parameters.get('backend');

/**
 * `?scene=examples/dice.usdc` opens that scene, `?project=examples/workshop.slowlight.json` that project;
 * `?lesson=aberration&step=3` opens a step of a lesson; `?backend=webgl` or `webgpu` forces a backend.
 */
void startEditor(createRoot(document.getElementById('root')!), {
  scene: parameters.get('scene') ?? undefined,
  project: parameters.get('project') ?? undefined,
  lesson: lessonPlaceOf(parameters),
  backend: wanted === 'webgl' || wanted === 'webgpu' ? wanted : 'auto',
});
