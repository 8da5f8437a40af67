//! Looking for light where lamps are.

use common::film::Color;
use common::tally::{Event, Tally};
use path_tracing::bsdf::Bsdf;
use path_tracing::random::Random;
use path_tracing::space::{Met, Space};
use path_tracing::strategy::Lighting;
use path_tracing::vertex::{Departure, Vertex};
use shadows::visibility::{End, visible};

use crate::lights::{LightSample, Lights};

/// Points of lamps that were looked at.
pub const LIGHT_SAMPLES: Event = Event::new(13, 0, "light_samples");

// ANCHOR: by_light
/// Light straight from lamps is found by looking at points of them, and by nothing else: where a
/// path comes upon a lamp by itself, that light has been counted already. It counts only where it
/// could not be looked for: from the eye, and from mirrors and glass (the report's erratum 5).
#[derive(Clone, Copy, Debug)]
pub struct ByLight<'a> {
    /// The lamps.
    pub lights: &'a Lights,
}

impl Lighting for ByLight<'_> {
    #[inline]
    fn direct<B: Bsdf, T: Tally>(
        &self,
        space: &Space,
        vertex: &Vertex<B>,
        random: &Random,
        tally: &mut T,
    ) -> Color {
        match self.lights.sample(vertex.hit().point, random) {
            Some(sample) => arriving(space, vertex, &sample, tally) / sample.pdf,
            None => Color::ZERO,
        }
    }

    #[inline]
    fn share(&self, departure: &Departure, met: &Met) -> f32 {
        if departure.is_delta || !self.lights.can_choose(met.piece) { 1.0 } else { 0.0 }
    }
}
// ANCHOR_END: by_light

// ANCHOR: arriving
/// What leaves `vertex` towards the eye of the light of a lamp's point, per steradian of it: nothing
/// if something is in between.
#[inline]
pub fn arriving<B: Bsdf, T: Tally>(
    space: &Space,
    vertex: &Vertex<B>,
    sample: &LightSample,
    tally: &mut T,
) -> Color {
    tally.count(LIGHT_SAMPLES, 1);
    let incoming = vertex.frame.to_local(sample.point.direction);
    let part = vertex.bsdf.eval(vertex.outgoing, incoming) * incoming.z.abs();
    // A shadow ray is the dearest part of it: none where nothing would come of it.
    if part == Color::ZERO || !visible(space, End::On(vertex.hit()), End::On(sample.hit()), tally) {
        return Color::ZERO;
    }
    part * sample.radiance
}
// ANCHOR_END: arriving

#[cfg(test)]
mod tests {
    use common::film::Color;
    use glam::Vec3;
    use path_tracing::part::{Form, Part};
    use path_tracing::smooth::Smooth;
    use path_tracing::stage::Stage;
    use path_tracing::strategy::ByDirection;

    use super::ByLight;
    use crate::lamp::Way;
    use crate::lights::{Choice, Lights};
    use crate::naive::{Counted, Multiplied, Rule};
    use crate::scenes::named;
    use crate::tiles::{Runs, least_p_value, stage, tiles};

    /// So often may right code be refused by one of these tests; the seeds are fixed.
    const SIGNIFICANCE: f64 = 0.01;
    const RUNS: Runs = Runs { side: 16, spp: 4, count: 40, depth: 3 };

    #[track_caller]
    fn accepted(p_value: f64) {
        assert!(p_value > SIGNIFICANCE, "{p_value}");
    }

    #[track_caller]
    fn refused(p_value: f64) {
        assert!(p_value < 1e-6, "{p_value}");
    }

    fn lights(stage: &Stage<Smooth>, way: Way) -> Lights {
        Lights::new(&stage.space, &stage.surfaces, Choice::Power, way)
    }

    #[test]
    fn three_ways_to_look_find_the_same_light() {
        let stage = stage("cornell");
        let [area, angle] = [Way::Area, Way::SolidAngle].map(|way| lights(&stage, way));
        // Paths that come upon the lamp by chance are rare: more of them.
        let by_chance = tiles(&stage, ByDirection, &Runs { spp: 64, ..RUNS });
        let by_area = tiles(&stage, ByLight { lights: &area }, &RUNS);
        let by_angle = tiles(&stage, ByLight { lights: &angle }, &RUNS);
        for (one, other) in [(&by_chance, &by_area), (&by_chance, &by_angle), (&by_area, &by_angle)]
        {
            accepted(least_p_value(one, other));
        }
    }

    /// The power of the test above: what counts the light of the lamp twice differs, and so does what
    /// multiplies by the squared distance; so would 8 % more or less everywhere.
    #[test]
    fn planted_errors_are_found() {
        let stage = stage("cornell");
        let lights = lights(&stage, Way::Area);
        let lighting = ByLight { lights: &lights };
        let right = tiles(&stage, lighting, &RUNS);
        let twice = Counted { lighting, rule: Rule::Always };
        refused(least_p_value(&right, &tiles(&stage, twice, &RUNS)));
        refused(least_p_value(&right, &tiles(&stage, Multiplied(lighting), &RUNS)));
        let other = Runs { count: 60, ..RUNS };
        let again = tiles(&stage, lighting, &other);
        let more: Vec<_> = again.iter().map(|tile| tile.scaled(1.08)).collect();
        accepted(least_p_value(&right, &again));
        refused(least_p_value(&right, &more));
    }

    /// Inside a cube that glows everything has the radiance 1 + a + a² + a³, for paths of three
    /// bounces. A radiance that is 2 % higher is refused.
    #[test]
    fn a_furnace_shows_nothing() {
        let stage = stage("furnace");
        let lights = lights(&stage, Way::SolidAngle);
        let lighting = ByLight { lights: &lights };
        let found = tiles(&stage, lighting, &RUNS);
        let right = |value: f64| found.iter().map(|_| Runs::exact(value)).collect::<Vec<_>>();
        accepted(least_p_value(&found, &right(1.875)));
        refused(least_p_value(&found, &right(1.875 * 1.02)));
        let twice = tiles(&stage, Counted { lighting, rule: Rule::Always }, &RUNS);
        refused(least_p_value(&twice, &right(1.875)));
    }

    /// In a ball, both cosines are half the distance over the radius: with points chosen by area each
    /// sample is the albedo itself.
    #[test]
    fn in_a_ball_of_light_there_is_no_noise() {
        let stage = stage("furnace-ball");
        let lights = lights(&stage, Way::Area);
        for tile in tiles(&stage, ByLight { lights: &lights }, &RUNS) {
            assert!((tile.mean() - 1.875).abs() < 1e-4, "{tile:?}");
            assert!(tile.standard_error() < 1e-5, "{tile:?}");
        }
    }

    /// Erratum 8: the same scene a thousand times as large or as small, and the same picture.
    #[test]
    fn a_thousand_times_larger_or_smaller_is_the_same_picture_to_the_bit() {
        let runs = Runs { count: 1, ..RUNS };
        for (name, way) in [("cornell-glass", Way::Area), ("sphere-light", Way::SolidAngle)] {
            let pictures = [1.0, 1024.0, 1.0 / 1024.0].map(|scale| {
                let mut model = named(name, 0.5).expect("a scene");
                model.parts.iter_mut().for_each(|part| scaled(&mut part.form, scale));
                model.view.eye *= scale;
                model.view.target *= scale;
                let stage = Stage::new(&model).expect("a scene");
                let lights = lights(&stage, way);
                let found = tiles(&stage, ByLight { lights: &lights }, &runs);
                found.iter().map(|tile| tile.mean().to_bits()).collect::<Vec<_>>()
            });
            assert_eq!(pictures[0], pictures[1], "{name}, larger");
            assert_eq!(pictures[0], pictures[2], "{name}, smaller");
        }
    }

    fn scaled(form: &mut Form, scale: f32) {
        match form {
            Form::Triangles(triangles) => {
                triangles.iter_mut().flatten().for_each(|corner| *corner *= scale);
            }
            Form::Ball(ball) => {
                ball.center *= scale;
                ball.radius *= scale;
            }
        }
    }

    /// Erratum 5: what a mirror shows of a lamp can't be looked for. The report's rule shows black.
    #[test]
    fn a_mirror_shows_the_lamp() {
        let stage = stage("cornell-glass");
        let lights = lights(&stage, Way::Area);
        let lighting = ByLight { lights: &lights };
        let runs = Runs { spp: 64, ..RUNS };
        let right = tiles(&stage, lighting, &runs);
        accepted(least_p_value(&right, &tiles(&stage, ByDirection, &runs)));
        let rule = Rule::OnlyFrom(stage.camera.eye());
        refused(least_p_value(&right, &tiles(&stage, Counted { lighting, rule }, &runs)));
    }

    /// And where everything is matte, it is right, to the bit.
    #[test]
    fn the_published_rule_is_right_without_mirrors() {
        let stage = stage("cornell");
        let lights = lights(&stage, Way::Area);
        let lighting = ByLight { lights: &lights };
        let runs = Runs { count: 2, ..RUNS };
        let rule = Rule::OnlyFrom(stage.camera.eye());
        let published = tiles(&stage, Counted { lighting, rule }, &runs);
        assert_eq!(published, tiles(&stage, lighting, &runs));
    }

    /// What can't be looked at adds nothing, or is found by chance: never NaN.
    #[test]
    fn odd_lamps_have_a_defined_result() {
        let corners = |points: [[f32; 3]; 3]| Form::Triangles(vec![points.map(Vec3::from_array)]);
        let line = corners([[0.0, 500.0, 0.0], [100.0, 500.0, 100.0], [200.0, 500.0, 200.0]]);
        let behind = corners([[0.0, 0.0, 900.0], [500.0, 0.0, 900.0], [0.0, 500.0, 900.0]]);
        let small =
            corners([[200.0, 500.0, 200.0], [200.0, 500.0, 200.001], [200.001, 500.0, 200.0]]);
        let glow = Color::splat(5.0);
        for (form, is_dark) in [(line, true), (behind, true), (small, false)] {
            let mut model = named("dark", 0.5).expect("a scene");
            model.parts.push(Part::glowing(form, Smooth::BLACK, glow));
            let stage = Stage::new(&model).expect("a scene");
            for way in [Way::Area, Way::SolidAngle] {
                let lights = lights(&stage, way);
                let found = tiles(&stage, ByLight { lights: &lights }, &Runs { count: 2, ..RUNS });
                let sum: f64 = found.iter().map(|tile| tile.mean()).sum();
                assert_eq!(sum == 0.0, is_dark, "{way:?}: {sum}");
                assert!(sum.is_finite());
            }
        }
    }

    #[test]
    fn an_eye_in_a_wall_sees_what_is_there() {
        let mut model = named("cornell", 0.5).expect("a scene");
        model.view.eye = Vec3::new(278.0, 0.0, 280.0);
        model.view.target = Vec3::new(278.0, 100.0, 281.0);
        let stage = Stage::new(&model).expect("a scene");
        let lights = lights(&stage, Way::SolidAngle);
        let found = tiles(&stage, ByLight { lights: &lights }, &Runs { count: 2, ..RUNS });
        assert!(found.iter().all(|tile| tile.mean().is_finite() && tile.mean() >= 0.0));
    }
}
