import { inClauses, type LocalizedText, msg } from '../../messages/message.ts';
import { HYPERSURFACES, type Hypersurface } from '../../physics/worldLines/hypersurface.ts';
import { galilean } from './galilean.ts';
import { lightCone } from './lightCone.ts';
import { simultaneity } from './simultaneity.ts';
import type { ViewRecord, ViewToggles } from './viewRecord.ts';

/** All views, in the order of menus. */
const VIEW_LIST = { 'light-cone': lightCone, simultaneity, galilean } as const satisfies Readonly<
  Record<string, ViewRecord>
>;
/** Which events a picture shows, and where: `light-cone` (as seen), `simultaneity`, `galilean`. */
export type View = keyof typeof VIEW_LIST;
export const VIEWS: Readonly<Record<View, ViewRecord>> = VIEW_LIST;
export const VIEW_NAMES = Object.keys(VIEW_LIST) as readonly View[];

export interface ViewSettings extends ViewToggles {
  readonly view: View;
}

/** The events that a picture with these settings is made of. */
export const hypersurfaceOf = (settings: ViewSettings): Hypersurface =>
  HYPERSURFACES[VIEWS[settings.view].hypersurface(settings)];

const records = Object.values(VIEWS);

export const VIEW_TITLES = Object.fromEntries(VIEW_NAMES.map((name) => [name, VIEWS[name].title])) as Readonly<
  Record<View, LocalizedText>
>;

const [lastView, ...otherViews] = [...records].reverse();

/** What the choice of a view is about, in its control and in `--help`. */
export const VIEW_HELP = {
  control: msg`${inClauses(otherViews.reverse().map(({ help }) => help))}; or ${lastView!.help}.`,
  flag: inClauses(VIEW_NAMES.map((name) => msg`${name}: ${VIEWS[name].summary}`)),
};
