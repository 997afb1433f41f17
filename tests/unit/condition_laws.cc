// What conditions and parameters are made of: constants in braces, amplitudes
// over the load time, cylindrical components, intervals of the load time.

#include <deal.II/base/mpi.h>

#include <stickslip/base/amplitude.h>
#include <stickslip/base/named_constants.h>
#include <stickslip/base/parameter_file.h>
#include <stickslip/base/user_error.h>

#include <stickslip/solid/active_interval.h>
#include <stickslip/solid/cylindrical_frame.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

using namespace dealii;
using namespace stickslip;

void
expect_user_error(const std::function<void()> &action)
{
  try
    {
      action();
      std::cout << "accepted" << std::endl;
    }
  catch (const UserError &error)
    {
      std::cout << error.what() << std::endl;
    }
}



void
test_constants()
{
  std::cout << "-- constants" << std::endl;
  ParameterFile file = ParameterFile::from_string(
    "subsection Constants\n"
    "  set width = 40\n"
    "  set half = width / 2\n"
    "  set deep = -half\n"
    "  set E = 2.1e5\n"
    "  set third = 1/3\n"
    "end\n"
    "set a = {width}\n"
    "set b = 0, {half + 1} : {2*width}\n"
    "set c = {deep}^2 + {deep}\n"
    "set d = {third}\n"
    "set e = {1e6 * pi / pi}\n"
    "set f = no braces\n"
    "set g = case_{width}.msh\n",
    "case.prm");
  const auto show = [](const ParameterFile &given) {
    const ParameterFile inserted = given.with_constants_inserted();
    for (const auto &entry : inserted.entries())
      std::cout << entry.full_name() << " = " << entry.value << std::endl;
  };
  show(file);
  std::cout << "with another width" << std::endl;
  file.override_with("Constants/width=10");
  show(file);
  expect_user_error([&] { file.override_with("Constants/widht=1"); });

  for (const std::string text :
       {"subsection Constants\nset a = b\nend\n",
        "subsection Constants\nset a = 1/0\nend\n",
        "subsection Constants\nset 2a = 1\nend\n",
        "subsection Constants\nset a b = 1\nend\n",
        "subsection Constants\nset sin = 1\nend\n",
        "subsection Constants\nset a =\nend\n",
        "subsection Constants\nsubsection a\nset b = 1\n"
        "end\nend\n",
        "set x = {width",
        "set x = width}",
        "set x = {{width}}",
        "set x = {}",
        "set x = {width}\nset y = {high}"})
    expect_user_error([&] {
      ParameterFile::from_string(text, "case.prm").with_constants_inserted();
    });
}



void
print_values(const Amplitude &amplitude)
{
  for (const double t : {-1., 0., 0.25, 0.5, 1., 1.5, 2., 2.5, 3., 7.25})
    std::cout << ' ' << amplitude.value(t);
  std::cout << std::endl;
}



void
test_amplitudes()
{
  std::cout << "-- amplitudes" << std::endl;
  const std::vector<std::pair<double, double>> table = {{0., 0.},
                                                        {1., 4.},
                                                        {2., 4.},
                                                        {3., 0.}};
  for (const auto interpolation : {AmplitudeInterpolation::linear,
                                   AmplitudeInterpolation::smooth,
                                   AmplitudeInterpolation::step})
    for (const bool repeat : {false, true})
      print_values(Amplitude(table, interpolation, repeat));
  // 10 s^3 - 15 s^4 + 6 s^5: flat at both ends
  const Amplitude smooth(table, AmplitudeInterpolation::smooth, false);
  std::cout << "smooth: slopes at the points below 1e-6: "
            << (std::abs(smooth.value(1e-4)) < 1e-10 &&
                std::abs(smooth.value(1. - 1e-4) - 4.) < 1e-10)
            << std::endl;

  const auto with_file = [](const std::string &content) {
    std::ofstream("amplitude.csv") << content;
    NamedList<AmplitudeParameters> list(1);
    list[0].first       = "ramp";
    list[0].second.file = "amplitude.csv";
    return make_amplitudes(list, ".", MPI_COMM_WORLD);
  };
  const auto read =
    with_file("time, factor\r\n# a remark\n0, 0\n1; 4\n2\t4\n\n3 0 # end\n");
  print_values(*amplitude_called("ramp", read, "here"));
  expect_user_error([&] { amplitude_called("rmap", read, "here"); });
  for (const std::string content : {"",
                                    "0, 1\n",
                                    "0, 1\n1, a\n",
                                    "0, 1\n2\n",
                                    "0, 1\n0, 2\n",
                                    "0, 1\n1, nan\n"})
    expect_user_error([&] { with_file(content); });
  NamedList<AmplitudeParameters> none(1);
  none[0].first       = "ramp";
  none[0].second.file = "no_such_file.csv";
  expect_user_error([&] { make_amplitudes(none, ".", MPI_COMM_WORLD); });
  expect_user_error([] { AmplitudeParameters().check("Amplitudes/a"); });
}



void
test_frames()
{
  std::cout << "-- cylindrical components" << std::endl;
  const Tensor<1, 3>        z({0., 0., 1.});
  const CylindricalFrame<2> plane(Point<2>(1., 2.), z);
  const Point<2>            x(1. + 3., 2. + 4.);
  std::cout << plane.direction(x, 0) << " | " << plane.direction(x, 1)
            << std::endl;
  std::cout << plane.vector(x, Tensor<1, 2>({10., 5.})) << std::endl;

  // radial, circumferential and axial are a right-handed orthonormal triple
  const Tensor<1, 3>        axis = Tensor<1, 3>({1., 2., 2.}) / 3.;
  const CylindricalFrame<3> frame(Point<3>(0., 1., 0.), axis);
  const Point<3>            p(0.3, -0.7, 1.1);
  const Tensor<1, 3> r = frame.direction(p, 0), t = frame.direction(p, 1),
                     a = frame.direction(p, 2);
  std::cout << "orthonormal: "
            << (std::abs(r.norm() - 1.) + std::abs(r * a) +
                  (cross_product_3d(r, t) - a).norm() <
                1e-14)
            << ", away from the axis: " << (r * (p - Point<3>(0., 1., 0.)) > 0.)
            << std::endl;
  std::cout << "on the axis: "
            << frame.direction(Point<3>(0., 1., 0.) + 2. * axis, 0).norm()
            << std::endl;
}



void
test_intervals()
{
  std::cout << "-- intervals" << std::endl;
  ActiveInterval interval;
  std::cout << interval.contains(-1e30) << interval.contains(1e30);
  interval.from = 0.3;
  std::cout << interval.contains(0.1 + 0.2) << interval.contains(0.29);
  interval.until = 1.;
  std::cout << interval.contains(1.) << interval.contains(1.0001) << std::endl;
}



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_constants();
  test_amplitudes();
  test_frames();
  test_intervals();
}
