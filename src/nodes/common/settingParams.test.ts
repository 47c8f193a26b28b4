import { expect, it } from 'vitest';
import { isParamActive, resolveParams } from '../../graph/nodeType.ts';
import { VIEW_NAMES } from '../../scene/views/views.ts';
import { nodeLibrary } from '../library.ts';

it('a solver is offered in views that search for events, and its steps with Newton’s alone', () => {
  const type = nodeLibrary['relativity-console'];
  const offered = (view: string, solver: string) =>
    (['solver', 'iterations', 'damping'] as const).filter((name) =>
      isParamActive(type, type.params[name], resolveParams(type, { view, solver })),
    );
  for (const view of VIEW_NAMES) {
    const searches = view === 'light-cone' || view === 'simultaneity';
    expect(offered(view, 'exact')).toEqual(searches ? ['solver'] : []);
    expect(offered(view, 'newton')).toEqual(searches ? ['solver', 'iterations', 'damping'] : []);
  }
});
