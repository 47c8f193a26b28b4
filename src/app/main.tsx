import { createRoot } from 'react-dom/client';
import { startEditor } from '../editor/start.tsx';

const parameters = new URLSearchParams(location.search);
const wanted = parameters.get('backend');

/**
 * `?scene=examples/dice.usdc` opens that scene, `?project=examples/workshop.slowlight.json` that project;
 * `?backend=webgl` or `webgpu` forces a backend.
 */
void startEditor(createRoot(document.getElementById('root')!), {
  scene: parameters.get('scene') ?? undefined,
  project: parameters.get('project') ?? undefined,
  backend: wanted === 'webgl' || wanted === 'webgpu' ? wanted : 'auto',
});
