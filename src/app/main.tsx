import { createRoot } from 'react-dom/client';
import { startEditor } from '../editor/start.tsx';

const parameters = new URLSearchParams(location.search);
const wanted = parameters.get('backend');

/** `?scene=examples/dice.usda` opens that scene, `?backend=webgl` or `webgpu` takes that and no other. */
void startEditor(createRoot(document.getElementById('root')!), {
  source: parameters.get('scene') ?? 'examples/street.usda',
  backend: wanted === 'webgl' || wanted === 'webgpu' ? wanted : 'auto',
});
