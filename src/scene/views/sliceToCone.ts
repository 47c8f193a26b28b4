import { add, scale } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import { inverseBoost } from '../../physics/lorentz/boost.ts';
import { shallowCone, shallowPosition } from '../../physics/worldLines/shallowCone.ts';
import { velocityAt } from '../../physics/worldLines/worldLine.ts';
import { lightCone } from './lightCone.ts';
import { simultaneity } from './simultaneity.ts';
import type { ViewRecord } from './viewRecord.ts';

/** What a value of the slider shows: the views at its ends, or what is between. */
const at = <T>(slope: number, [moment, between, seen]: readonly [T, T, T]): T =>
  slope <= 0 ? moment : slope >= 1 ? seen : between;

export const DEFAULT_CONE_SLOPE = 0.5;

/** From what is to what is seen: the events ct′ = −λr′ of the observer's frame, from his moment (λ = 0) to his past light cone (λ = 1). docs/physics.md §5.8. */
export const sliceToCone: ViewRecord = {
  title: msg`Between`,
  summary: msg`between positions at one instant and what is seen`,
  help: msg`what lies between that instant and what you see`,
  luminous: ({ coneSlope }) => coneSlope >= 1,
  relativistic: true,
  hypersurface: ({ coneSlope }) => at(coneSlope, ['slice', 'shallow-cone', 'past-light-cone']),
  placement: ({ coneSlope }) => at(coneSlope, ['contracted', 'shallow', 'apparent']),
  rayToward(n, u, toggles) {
    const { coneSlope } = toggles;
    if (coneSlope >= 1) return lightCone.rayToward(n, u, { ...toggles, lightDelay: true, aberration: true });
    if (coneSlope <= 0) return simultaneity.rayToward(n, u, toggles);
    return inverseBoost([-coneSlope, ...n], u);
  },
  probe(line, observer, c, options) {
    const { coneSlope = DEFAULT_CONE_SLOPE } = options;
    if (coneSlope >= 1) return lightCone.probe(line, observer, c, options);
    if (coneSlope <= 0) return simultaneity.probe(line, observer, c, options);
    const { u } = observer;
    const { offset, ahead } = shallowCone(coneSlope).intersect(line, observer, u, c)!;
    const time = observer.t + ahead / c;
    return {
      time,
      position: add(observer.position, offset),
      velocity: scale(velocityAt(line, time, c), 1 / c),
      apparent: shallowPosition(offset, u, coneSlope),
      doppler: 1,
    };
  },
};
