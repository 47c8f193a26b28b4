import { inClauses, type LocalizedText, msg } from '../../messages/message.ts';
import { type Placement, placementOf } from '../../physics/optics/placement.ts';
import type { HypersurfaceChoice } from '../../physics/worldLines/hypersurface.ts';
import { galilean } from './galilean.ts';
import { lightCone } from './lightCone.ts';
import { simultaneity } from './simultaneity.ts';
import { sliceToCone } from './sliceToCone.ts';
import type { ViewRecord, ViewToggles } from './viewRecord.ts';

/** All views, in the order of menus. */
const VIEW_LIST = {
  'light-cone': lightCone,
  simultaneity,
  'slice-to-cone': sliceToCone,
  galilean,
} as const satisfies Readonly<Record<string, ViewRecord>>;
/** Which events a picture shows, and where: `light-cone` (as seen), `simultaneity`, `slice-to-cone` (between), `galilean`. */
export type View = keyof typeof VIEW_LIST;
export const VIEWS: Readonly<Record<View, ViewRecord>> = VIEW_LIST;
export const VIEW_NAMES = Object.keys(VIEW_LIST) as readonly View[];

export interface ViewSettings extends ViewToggles {
  readonly view: View;
}

/** The events that a picture with these settings is made of. */
export const hypersurfaceChoice = (settings: ViewSettings): HypersurfaceChoice => ({
  hypersurface: VIEWS[settings.view].hypersurface(settings),
  coneSlope: settings.coneSlope,
});

/** Whether a picture with these settings shows light, with Doppler shift and beaming. */
export const isLuminous = (settings: ViewSettings): boolean => VIEWS[settings.view].luminous(settings);

/** Where a picture with these settings shows its events. */
export const placementIn = (settings: ViewSettings): Placement =>
  placementOf(VIEWS[settings.view].placement(settings), settings.coneSlope);

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
