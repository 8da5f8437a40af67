"""A rough conductor whose Smith term is height-correlated, as Mitsuba's own is not.

Eric Heitz, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs" (Journal of
Computer Graphics Techniques 3, 2014): equations 71 and 72 (GGX), 98 (separable) and 99
(height-correlated). One bounce between microfacets; what would bounce again is lost.
"""

import drjit as dr
import mitsuba as mi


class RoughMetal(mi.BSDF):
    """Properties: alpha; eta and k, a number each for red, green and blue; and for checks
    correlated (separable if not) and mirror (Fresnel's factor is 1)."""

    def __init__(self, props):
        mi.BSDF.__init__(self, props)
        self.alpha = props["alpha"]
        self.index = list(zip(props["eta"], props["k"]))
        self.correlated = props.get("correlated", True)
        self.mirror = props.get("mirror", False)
        flags = mi.BSDFFlags.GlossyReflection | mi.BSDFFlags.FrontSide
        self.m_components = [flags]
        self.m_flags = flags

    def hidden(self, w):
        """Smith's lambda: equation 72."""
        tan_squared = (dr.square(w.x) + dr.square(w.y)) / dr.square(w.z)
        return (dr.sqrt(1 + self.alpha**2 * tan_squared) - 1) / 2

    def facets(self, h):
        """The density of facets with the normal h: equation 71."""
        slopes = (dr.square(h.x) + dr.square(h.y)) / self.alpha**2 + dr.square(h.z)
        return 1 / (dr.pi * self.alpha**2 * dr.square(slopes))

    def both_visible(self, wi, wo):
        if self.correlated:
            return 1 / (1 + self.hidden(wi) + self.hidden(wo))
        return 1 / ((1 + self.hidden(wi)) * (1 + self.hidden(wo)))

    def reflected(self, cosine):
        if self.mirror:
            return mi.Color3f(1)
        return mi.Color3f([mi.fresnel_conductor(cosine, mi.Complex2f(n, k)) for n, k in self.index])

    def sample(self, ctx, si, sample1, sample2, active=True):
        normals = mi.MicrofacetDistribution(mi.MicrofacetType.GGX, self.alpha, True)
        h, _ = normals.sample(si.wi, sample2)
        bs = dr.zeros(mi.BSDFSample3f)
        bs.wo = mi.reflect(si.wi, h)
        bs.eta = 1.0
        bs.sampled_component = mi.UInt32(0)
        bs.sampled_type = mi.UInt32(+mi.BSDFFlags.GlossyReflection)
        bs.pdf = self.pdf(ctx, si, bs.wo, active)
        active &= (si.wi.z > 0) & (bs.wo.z > 0) & (bs.pdf > 0)
        # The density of visible normals holds D and the masking of wi already.
        share = self.both_visible(si.wi, bs.wo) * (1 + self.hidden(si.wi))
        return bs, dr.select(active, self.reflected(dr.dot(si.wi, h)) * share, 0)

    def eval(self, ctx, si, wo, active=True):
        h = dr.normalize(si.wi + wo)
        active &= (si.wi.z > 0) & (wo.z > 0)
        value = self.facets(h) * self.both_visible(si.wi, wo) / (4 * si.wi.z)
        return dr.select(active, self.reflected(dr.dot(si.wi, h)) * value, 0)

    def pdf(self, ctx, si, wo, active=True):
        h = dr.normalize(si.wi + wo)
        active &= (si.wi.z > 0) & (wo.z > 0)
        density = self.facets(h) / ((1 + self.hidden(si.wi)) * 4 * si.wi.z)
        return dr.select(active, density, 0)

    def eval_pdf(self, ctx, si, wo, active=True):
        return self.eval(ctx, si, wo, active), self.pdf(ctx, si, wo, active)

    def to_string(self):
        return f"RoughMetal[alpha = {self.alpha}]"


def register():
    """Makes it known to Mitsuba as "roughmetal"."""
    mi.register_bsdf("roughmetal", RoughMetal)
